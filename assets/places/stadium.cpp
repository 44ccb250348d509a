#include "assets/places/arithmetic.h"
#include "assets/places/paints.h"
#include "assets/places/props.h"
#include "assets/places/shapes.h"

namespace throng::places {
namespace {

/// A block of a tier, from its top at y = 0 downwards, to be stretched.
void seat_block(MeshBuilder& builder, int) {
  Paint concrete = paints::matt(0xB7B3AA);
  concrete.baked = false;
  Paint low = shaded(concrete, 0.55);
  const Corner a{{-0.5, -1, 0.5}, low}, b{{0.5, -1, 0.5}, low}, c{{0.5, 0, 0.5}, concrete}, d{{-0.5, 0, 0.5}, concrete};
  builder.add({{a, b, c, d}, 4});
  box(builder, {-0.5, -1, -0.5}, {0.5, 0, 0.5}, concrete, side::top);
  box(builder, {-0.5, -1, -0.5}, {0.5, 0, 0.5}, shaded(concrete, 0.75), side::back | side::left | side::right);
}

/// A folding seat of plastic, 0.44 m high; who sits on it faces +Z.
void seat(MeshBuilder& builder, int lod) {
  const Paint plastic = paints::tinted(0xF0EEEA);
  const Paint under = shaded(plastic, 0.6);
  if (lod >= 1) {
    // Coarse seats cast the shadows, also on fine ones, so they lie a little behind these.
    box(builder, {-0.22, 0.38, -0.2}, {0.22, 0.42, 0.2}, plastic,
        lod == 1 ? side::front | side::top : unsigned{side::top});
    builder.quad({-0.22, 0.42, -0.22}, {0.22, 0.42, -0.22}, {0.22, 0.82, -0.28}, {-0.22, 0.82, -0.28}, plastic);
    if (lod == 1)
      builder.quad({0.22, 0.42, -0.23}, {-0.22, 0.42, -0.23}, {-0.22, 0.82, -0.29}, {0.22, 0.82, -0.29}, under);
    return;
  }
  const std::vector<dvec2> profile{{0.2, 0.4},    {0.22, 0.43},  {0.2, 0.44},  {0.05, 0.425}, {-0.12, 0.43},
                                   {-0.19, 0.48}, {-0.23, 0.62}, {-0.26, 0.8}, {-0.27, 0.82}};
  const int group = builder.fresh_smooth();
  const int behind = builder.fresh_smooth();
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const dvec2 p = profile[i], q = profile[i + 1];
    builder.quad({-0.22, p.y, p.x}, {0.22, p.y, p.x}, {0.22, q.y, q.x}, {-0.22, q.y, q.x}, plastic, group);
    builder.quad({0.22, p.y - 0.03, p.x - 0.02}, {-0.22, p.y - 0.03, p.x - 0.02}, {-0.22, q.y - 0.03, q.x - 0.02},
                 {0.22, q.y - 0.03, q.x - 0.02}, under, behind);
  }
  for (const double x : {-0.16, 0.16})
    box(builder, {x - 0.02, 0, -0.16}, {x + 0.02, 0.4, -0.1}, paints::steel,
        side::front | side::back | side::left | side::right);
}

/// Six metres of a stadium's roof: a truss on a mast at z = 0 that carries a roof 14 m out to +Z, 14 m up.
void roof_bay(MeshBuilder& builder, int lod) {
  const Paint white = paints::metal(0xE3E6E6);
  Paint sheet = paints::matt(0xE9ECEA);
  sheet.baked = false;
  const int sides = lod == 0 ? 8 : lod == 1 ? 5 : 4;
  bar(builder, {0, 0.02, -1.5}, {0, 19, -2.2}, 0.35, 0.22, sides, white);
  const dvec3 tip(0, 15.2, 14), root(0, 13.2, -1.9), head(0, 19, -2.2);
  bar(builder, root, tip, 0.2, 0.14, sides, white);
  if (lod < 2) {
    bar(builder, head, {0, 15.0, 12.8}, 0.06, 0.06, 4, white);
    bar(builder, head, {0, 14.2, 6}, 0.06, 0.06, 4, white);
    bar(builder, head, {0, 6, -6}, 0.07, 0.07, 4, white);
    bar(builder, {0, 0, -6}, {0, 6, -6}, 0.12, 0.12, 4, white);
  }
  const int strips = lod == 0 ? 7 : lod == 1 ? 3 : 1;
  for (int i = 0; i < strips; ++i) {
    const double t0 = static_cast<double>(i) / strips, t1 = static_cast<double>(i + 1) / strips;
    const dvec3 a = root + (tip - root) * t0, b = root + (tip - root) * t1;
    const double y = 0.3;
    const Paint shade = shaded(sheet, i % 2 == 0 ? 1.0 : 0.93);
    builder.quad({-3, b.y + y, b.z}, {3, b.y + y, b.z}, {3, a.y + y, a.z}, {-3, a.y + y, a.z}, shade);
    builder.quad({-3, a.y + y - 0.08, a.z}, {3, a.y + y - 0.08, a.z}, {3, b.y + y - 0.08, b.z},
                 {-3, b.y + y - 0.08, b.z}, shaded(shade, 0.85));
    if (lod == 0) bar(builder, {-3, b.y + 0.12, b.z}, {3, b.y + 0.12, b.z}, 0.08, 0.08, 4, white, false);
  }
  box(builder, {-3, 15.1, 13.9}, {3, 15.6, 14.1}, paints::matt(0x2E4A7A), side::all_sides);
  if (lod > 1) return;
  for (const double x : {-2.0, -0.7, 0.7, 2.0}) {
    box(builder, {x - 0.3, 14.75, 13.6}, {x + 0.3, 15.1, 13.9},
        Paint{.color = rgb(0xF8F4E4), .glow = 255, .baked = false},
        side::front | side::bottom | side::left | side::right);
  }
}

/// A goal of 7.32 m by 2.44 m whose net lies behind it, at -Z.
void goal(MeshBuilder& builder, int lod) {
  constexpr double half = 3.72, height = 2.5, deep = 2.0;
  const Paint white = paints::matt(0xF4F4F0);
  const int sides = lod == 0 ? 8 : 4;
  for (const double x : {-half, half}) bar(builder, {x, 0, 0}, {x, height + 0.06, 0}, 0.06, 0.06, sides, white);
  bar(builder, {-half, height, 0}, {half, height, 0}, 0.06, 0.06, sides, white);
  if (lod > 1) return;
  const Paint net = paints::matt(0xD8DAD8);
  const int step = lod == 0 ? 24 : 10;
  const double w = lod == 0 ? 0.008 : 0.014;
  const auto back_y = [&](double z) { return height * (1 + z / deep * 0.55); };
  for (int i = 0; i <= step; ++i) {
    const double x = -half + 2 * half * i / step;
    bar(builder, {x, height, 0}, {x, back_y(-0.9), -0.9}, w, w, 3, net, false);
    bar(builder, {x, back_y(-0.9), -0.9}, {x, 0.02, -deep}, w, w, 3, net, false);
  }
  const int rows = lod == 0 ? 9 : 4;
  for (int j = 0; j <= rows; ++j) {
    const double t = static_cast<double>(j) / rows;
    const double y = 0.02 + (back_y(-0.9) - 0.02) * (1 - t), z = -0.9 - (deep - 0.9) * t;
    bar(builder, {-half, y, z}, {half, y, z}, w, w, 3, net, false);
    for (const double x : {-half, half}) bar(builder, {x, y, 0}, {x, y, z}, w, w, 3, net, false);
  }
}

/// A mast of 30 m with a frame of flood lights that look to +Z and down.
void flood_light(MeshBuilder& builder, int lod) {
  const Paint steel = paints::steel;
  const int sides = lod == 0 ? 8 : lod == 1 ? 5 : 3;
  bar(builder, {0, 0, 0}, {0, 28, 0}, 0.5, 0.25, sides, steel);
  if (lod < 2) box(builder, {-0.9, 0, -0.9}, {0.9, 0.5, 0.9}, paints::dark_stone);
  const Moved up(builder, {0, 28.5, 0.3});
  const Paint frame = paints::metal(0x5C6367);
  const auto tilted = [](double x, double y, double z) { return dvec3(x, y * 0.95 - z * 0.3, y * 0.3 + z * 0.95); };
  const auto face = [&](double x0, double y0, double x1, double y1, double z, const Paint& paint) {
    builder.quad(tilted(x0, y0, z), tilted(x1, y0, z), tilted(x1, y1, z), tilted(x0, y1, z), paint);
  };
  face(-2.4, -2, 2.4, 2, 0, frame);
  builder.quad(tilted(2.4, -2, -0.2), tilted(-2.4, -2, -0.2), tilted(-2.4, 2, -0.2), tilted(2.4, 2, -0.2), frame);
  const Paint light{.color = rgb(0xFFF8E6), .glow = 255, .baked = false};
  const int columns = lod == 0 ? 6 : lod == 1 ? 3 : 1;
  const int rows = lod == 0 ? 5 : lod == 1 ? 3 : 1;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double w = 4.6 / columns, h = 3.8 / rows;
      const double x = -2.3 + w * i, y = -1.9 + h * j;
      face(x + 0.08, y + 0.08, x + w - 0.08, y + h - 0.08, 0.12, light);
    }
  }
}

}  // namespace

std::vector<Prop> stadium_props() {
  return {{"seat_block", {0}, seat_block, 0.5},
          {"seat", {0, 0.03, 0.08}, seat, 0.3},
          {"roof_bay", {0, 0.06, 0.2}, roof_bay, 1.5},
          {"goal", {0, 0.02, 1.2}, goal, 0.3},
          {"flood_light", {0, 0.1, 0.4}, flood_light, 0.8}};
}

}  // namespace throng::places
