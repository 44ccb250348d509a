#include <algorithm>
#include <array>
#include <cmath>

#include "assets/places/arithmetic.h"
#include "assets/places/paints.h"
#include "assets/places/props.h"
#include "assets/places/shapes.h"

namespace throng::places {
namespace {

/// Value noise along a line, 0 to 1.
double noise(double x, std::uint32_t seed) {
  const double cell = std::floor(x);
  const double t = x - cell;
  const double smooth = t * t * (3 - 2 * t);
  const auto n = static_cast<std::uint32_t>(static_cast<int>(cell) + 4096);
  return chance(seed, n) + (chance(seed, n + 1) - chance(seed, n)) * smooth;
}

/// A ridge of wooded hills, 400 m long and some 60 m high, whose long side faces +Z.
void hill(MeshBuilder& builder, int lod) {
  const int columns = lod == 0 ? 40 : 16;
  const int rows = lod == 0 ? 6 : 3;
  const int group = builder.fresh_smooth();
  const auto at = [&](int i, int j) {
    const double u = static_cast<double>(i) / columns, v = static_cast<double>(j) / rows;
    const double x = -200 + 400 * u;
    const double envelope = sine(u * 0.5);
    const double height = envelope * (22 + 30 * noise(u * 5, 5) + 12 * noise(u * 13, 6));
    const double up = sine(v * 0.25);
    const double z = 70 - 110 * v;
    const double bumps = v > 0 && v < 1 ? 6 * (noise(u * 24 + v * 7, 8) - 0.5) : 0;
    return dvec3(x, height * up + bumps * envelope, z);
  };
  const auto paint_at = [&](int i, int j) {
    const double u = static_cast<double>(i) / columns, v = static_cast<double>(j) / rows;
    const double wood = noise(u * 18 + v * 31, 9);
    Paint paint = wood > 0.45 ? paints::matt(0x5B7448) : paints::matt(0x8E9A5C);
    paint.color *= 0.85 + 0.3 * noise(u * 40 + v * 11, 10);
    paint.baked = false;
    return paint;
  };
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const Corner a{at(i, j), paint_at(i, j)}, b{at(i + 1, j), paint_at(i + 1, j)},
          c{at(i + 1, j + 1), paint_at(i + 1, j + 1)}, d{at(i, j + 1), paint_at(i, j + 1)};
      builder.add({{a, b, c, d}, 4, group});
    }
  }
}

/// The houses of a far town, 120 m long, that faces +Z.
void far_houses(MeshBuilder& builder, int lod, std::uint32_t seed) {
  const int houses = 26;
  for (int i = 0; i < houses; ++i) {
    const auto n = static_cast<std::uint32_t>(i);
    const double width = 4 + 5 * chance(seed + 31U, n);
    const double x = -60 + 120.0 * (i + 0.5) / houses;
    const double z = -18 * chance(seed + 32U, n);
    const double height = 7 + 11 * chance(seed + 33U, n);
    constexpr std::array<std::uint32_t, 5> walls{0xE0CFAE, 0xD8B48E, 0xE6DCC6, 0xC9A588, 0xDAC7A2};
    Paint wall = paints::matt(walls[n % walls.size()]);
    wall.baked = false;
    Paint tile = chance(seed + 34U, n) < 0.7 ? paints::roof_tile : paints::slate;
    tile.baked = false;
    const Moved moved(builder, {x, 0, z});
    const double h = width / 2;
    box(builder, {-h, 0, -8}, {h, height, 0}, wall, side::front | side::left | side::right);
    const double ridge = height + 1.5 + 2 * chance(seed + 35U, n);
    if (chance(seed + 36U, n) < 0.6) {
      builder.quad({-h, height, 0.3}, {h, height, 0.3}, {h, ridge, -4}, {-h, ridge, -4}, tile);
      builder.triangle({h, height, 0}, {h, height, -8}, {h, ridge, -4}, wall);
      builder.triangle({-h, height, -8}, {-h, height, 0}, {-h, ridge, -4}, wall);
    } else {
      builder.triangle({-h, height, 0}, {h, height, 0}, {0, ridge + 1, 0}, wall);
      builder.quad({h, height, 0}, {h, height, -8}, {0, ridge + 1, -8}, {0, ridge + 1, 0}, tile);
      builder.quad({-h, height, -8}, {-h, height, 0}, {0, ridge + 1, 0}, {0, ridge + 1, -8}, tile);
    }
    if (lod > 0) continue;
    for (int storey = 0; storey < static_cast<int>(height / 3.2); ++storey) {
      for (int k = 0; k < static_cast<int>(width / 2.2); ++k) {
        const double wx = -h + 1.0 + 2.1 * k, wy = 1.2 + 3.1 * storey;
        if (wx + 0.9 > h || wy + 1.5 > height) continue;
        const auto m = n * 64 + static_cast<std::uint32_t>(storey * 8 + k);
        panel(builder, wx, wy, wx + 0.9, wy + 1.5, 0.1, paints::glass(chance(seed + 37U, m) < 0.4 ? 200 : 0));
      }
    }
  }
}

/// A church tower of a far town.
void far_tower(MeshBuilder& builder, dvec3 at, double height, double half, const Paint& roof) {
  const Moved moved(builder, at);
  const Paint stone = paints::matt(0xDDCFB4);
  lathe(builder, {{half * 1.4, 0}, {half * 1.4, height}, {half * 1.6, height + 0.5}}, 4, stone, Turned::faceted, 0.125);
  lathe(builder, {{half * 1.6, height + 0.5}, {0, height + 4.2 * half}}, 4, roof, Turned::faceted, 0.125);
}

/// Roofs and walls at many heights and one small tower, which may stand many times around a place.
void skyline(MeshBuilder& builder, int lod) {
  far_houses(builder, lod, 0);
  far_tower(builder, {33, 0, -16}, 19, 1.9, paints::roof_tile);
}

/// The same with a dome and two towers, which show from afar: for one place of a horizon.
void skyline_center(MeshBuilder& builder, int lod) {
  far_houses(builder, lod, 40);
  {
    const Paint stone = paints::matt(0xDDCFB4);
    const Moved dome(builder, {-22, 0, -20});
    lathe(builder, {{8, 0}, {8, 20}, {8.4, 20.5}, {7, 21}, {6.6, 25}}, 12, stone, Turned::faceted);
    lathe(builder, {{6.8, 25}, {6.2, 28}, {4.4, 31}, {1.5, 33}, {1.2, 35.5}, {0, 38}}, 12, paints::copper,
          Turned::round);
  }
  far_tower(builder, {18, 0, -16}, 30, 2.5, paints::copper);
  far_tower(builder, {41, 0, -16}, 24, 2.4, paints::slate);
}

}  // namespace

std::vector<Prop> horizon_props() {
  return {{"hill", {0, 2.5}, hill, 1.0},
          {"skyline", {0, 0.3}, skyline, 1.0},
          {"skyline_center", {0, 0.3}, skyline_center, 1.0}};
}

}  // namespace throng::places
