#include "assets/places/arithmetic.h"
#include "assets/places/house.h"
#include "assets/places/paints.h"

namespace throng::places {
namespace {

/// A slope laid with tiles, whose colour changes from patch to patch. (a, b) is its foot, (d, c) its ridge.
void tiled(MeshBuilder& builder, dvec3 a, dvec3 b, dvec3 c, dvec3 d, const Paint& tile, int columns, int rows,
           std::uint32_t seed) {
  const auto at = [&](double u, double v) {
    const dvec3 low = a + (b - a) * u;
    return low + (d + (c - d) * u - low) * v;
  };
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double u0 = static_cast<double>(i) / columns;
      const double u1 = static_cast<double>(i + 1) / columns;
      const double v0 = static_cast<double>(j) / rows;
      const double v1 = static_cast<double>(j + 1) / rows;
      const auto number = static_cast<std::uint32_t>(i * 16 + j);
      builder.quad(at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1), shaded(tile, 0.84 + 0.28 * chance(seed, number)));
    }
  }
}

}  // namespace

void gable_roof(MeshBuilder& builder, const Roof& roof, int lod, const Paint& party_wall) {
  const double middle = 0.5 * (roof.front_z + roof.back_z);
  const int columns = lod == 0 ? 5 : lod == 1 ? 2 : 1;
  const int rows = lod == 0 ? 3 : 1;
  const dvec3 ridge0(roof.x0, roof.ridge, middle);
  const dvec3 ridge1(roof.x1, roof.ridge, middle);
  const dvec3 f0(roof.x0, roof.eaves, roof.front_z);
  const dvec3 f1(roof.x1, roof.eaves, roof.front_z);
  const dvec3 b0(roof.x0, roof.eaves, roof.back_z);
  const dvec3 b1(roof.x1, roof.eaves, roof.back_z);
  tiled(builder, f0, f1, ridge1, ridge0, roof.tile, columns, rows, roof.seed);
  tiled(builder, b1, b0, ridge0, ridge1, roof.tile, 1, 1, roof.seed + 9);
  builder.triangle(b0, f0, ridge0, party_wall);
  builder.triangle(f1, b1, ridge1, party_wall);
  if (lod >= 2) return;
  const Paint edge = shaded(roof.tile, 0.7);
  builder.quad(f0 - dvec3(0, 0.12, 0), f1 - dvec3(0, 0.12, 0), f1, f0, edge);
  builder.quad(f0 - dvec3(0, 0.12, 0.6), f1 - dvec3(0, 0.12, 0.6), f1 - dvec3(0, 0.12, 0), f0 - dvec3(0, 0.12, 0),
               shaded(paints::timber, 0.8));
  box(builder, {roof.x0, roof.ridge - 0.06, middle - 0.12}, {roof.x1, roof.ridge + 0.07, middle + 0.12}, edge,
      side::front | side::back | side::top | side::left | side::right);
}

void mansard_roof(MeshBuilder& builder, const Roof& roof, int lod, const Paint& party_wall) {
  const int columns = lod == 0 ? 5 : lod == 1 ? 2 : 1;
  const int rows = lod == 0 ? 2 : 1;
  constexpr double back_by = 1.1;
  const double f = roof.front_z - back_by;
  const double b = roof.back_z + back_by;
  const double rise = roof.ridge - roof.eaves;
  const double knee = roof.eaves + rise * 0.72;
  const auto at = [&](double x, double y, double z) { return dvec3(x, y, z); };
  const double middle = 0.5 * (f + b);
  tiled(builder, at(roof.x0, roof.eaves, roof.front_z), at(roof.x1, roof.eaves, roof.front_z), at(roof.x1, knee, f),
        at(roof.x0, knee, f), roof.tile, columns, rows, roof.seed);
  tiled(builder, at(roof.x1, roof.eaves, roof.back_z), at(roof.x0, roof.eaves, roof.back_z), at(roof.x0, knee, b),
        at(roof.x1, knee, b), roof.tile, 1, 1, roof.seed + 5);
  builder.quad(at(roof.x0, knee, f), at(roof.x1, knee, f), at(roof.x1, roof.ridge, middle),
               at(roof.x0, roof.ridge, middle), shaded(paints::granite, 0.8));
  builder.quad(at(roof.x0, roof.ridge, middle), at(roof.x1, roof.ridge, middle), at(roof.x1, knee, b),
               at(roof.x0, knee, b), shaded(paints::granite, 0.8));
  for (const double x : {roof.x0, roof.x1}) {
    const dvec3 a = at(x, roof.eaves, roof.front_z), c = at(x, knee, f), d = at(x, roof.ridge, middle),
                e = at(x, knee, b), g = at(x, roof.eaves, roof.back_z);
    if (x == roof.x1) {
      builder.quad(a, g, e, c, party_wall);
      builder.triangle(c, e, d, party_wall);
    } else {
      builder.quad(g, a, c, e, party_wall);
      builder.triangle(e, c, d, party_wall);
    }
  }
  if (lod >= 2) return;
  box(builder, {roof.x0, knee - 0.08, f - 0.02}, {roof.x1, knee + 0.12, f + 0.14}, shaded(roof.tile, 0.75),
      side::front | side::top | side::bottom);
}

void dormer(MeshBuilder& builder, dvec3 at, double width, double height, double depth, const Paint& wall,
            const Paint& tile, int lod, std::uint32_t seed) {
  if (lod >= 3) return;
  const Moved moved(builder, at);
  const double half = width / 2;
  const double peak = height + width * 0.34;
  if (lod >= 2) {
    box(builder, {-half, 0, -depth}, {half, height, 0}, wall, side::front | side::left | side::right | side::top);
    panel(builder, -half * 0.6, 0.2, half * 0.6, height - 0.15, 0.03, paints::glass(0));
    return;
  }
  panel(builder, -half, 0, half, height, 0, wall);
  builder.triangle({-half, height, 0}, {half, height, 0}, {0, peak - 0.06, 0}, wall);
  box(builder, {-half, 0, -depth}, {half, height, 0}, wall, side::left | side::right);
  const double over = half + 0.14;
  const double drop = height - 0.1;
  builder.quad({0, peak, 0.16}, {0, peak, -depth}, {-over, drop, -depth}, {-over, drop, 0.16}, tile);
  builder.quad({0, peak, -depth}, {0, peak, 0.16}, {over, drop, 0.16}, {over, drop, -depth}, tile);
  if (lod == 0) {
    builder.quad({0, peak - 0.1, 0.16}, {0, peak, 0.16}, {-over, drop, 0.16}, {-over, drop - 0.1, 0.16},
                 paints::white_paint);
    builder.quad({0, peak, 0.16}, {0, peak - 0.1, 0.16}, {over, drop - 0.1, 0.16}, {over, drop, 0.16},
                 paints::white_paint);
  }
  const WindowStyle style{
      .width = width * 0.62, .height = height - 0.35, .columns = 2, .rows = 2, .frame = paints::white_paint};
  const bool lit = chance(seed, 2) < 0.4;
  const double w = style.width / 2;
  panel(builder, -w - 0.05, 0.15, w + 0.05, 0.2 + style.height + 0.05, 0.02, style.frame);
  const int columns = lod == 0 ? 2 : 1;
  for (int i = 0; i < columns; ++i) {
    const double x0 = -w + (2 * w) * i / columns;
    panel(builder, x0 + 0.02, 0.2, x0 + 2 * w / columns - 0.02, 0.2 + style.height, 0.04, paints::glass(lit ? 170 : 0));
  }
}

void chimney(MeshBuilder& builder, dvec3 at, double height, const Paint& paint, int lod) {
  if (lod >= 3) return;
  const Moved moved(builder, at);
  box(builder, {-0.5, -1, -0.3}, {0.5, height, 0.3}, paint);
  if (lod >= 2) return;
  box(builder, {-0.57, height - 0.35, -0.37}, {0.57, height - 0.12, 0.37}, shaded(paint, 1.08),
      side::all_sides & ~side::top);
  if (lod >= 1) return;
  for (const double x : {-0.28, 0.02, 0.3}) {
    const Moved pot(builder, {x, height, 0});
    lathe(builder, {{0.13, 0}, {0.11, 0.5}}, 5, paints::matt(0xB4623E));
  }
}

}  // namespace throng::places
