#include <array>

#include <glm/geometric.hpp>

#include "assets/places/arithmetic.h"
#include "assets/places/paints.h"
#include "assets/places/props.h"
#include "assets/places/shapes.h"

namespace throng::places {
namespace {

/// A cloth on a grid. `at(u, v)` gives its places and `sway(u, v)` how far wind moves them.
template <typename At, typename Look>
void hung_cloth(MeshBuilder& builder, int columns, int rows, At at, Look look) {
  const int one = builder.fresh_smooth();
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double u0 = static_cast<double>(i) / columns, u1 = static_cast<double>(i + 1) / columns;
      const double v0 = static_cast<double>(j) / rows, v1 = static_cast<double>(j + 1) / rows;
      const Corner a{at(u0, v0), look(u0, v0)}, b{at(u1, v0), look(u1, v0)}, c{at(u1, v1), look(u1, v1)},
          d{at(u0, v1), look(u0, v1)};
      builder.add({{a, b, c, d}, 4, one});
    }
  }
}

Paint waving(std::uint32_t hex, double share) {
  Paint paint = paints::tinted(hex);
  paint.sway = static_cast<int>(share * 255);
  paint.baked = false;
  return paint;
}

/// A pole of 7 m with a cloth of 2.4 m by 1.5 m that flies to +X.
void flag(MeshBuilder& builder, int lod) {
  const Paint pole = paints::metal(0xC9CCCB);
  const int sides = lod == 0 ? 8 : lod == 1 ? 5 : 3;
  bar(builder, {0, 0, 0}, {0, 7, 0}, 0.055, 0.03, sides, pole);
  if (lod < 2) {
    lathe(builder, {{0.2, 0}, {0.2, 0.08}, {0.09, 0.16}, {0.07, 0.3}}, sides, paints::dark_stone);
    lathe(builder, {{0.03, 6.98}, {0.08, 7.08}, {0, 7.18}}, 6, paints::metal(0xC9A24A));
  }
  const int columns = lod == 0 ? 8 : lod == 1 ? 4 : 2;
  const auto at = [](double u, double v) {
    return dvec3(0.04 + 2.35 * u, 5.3 + 1.5 * v - 0.28 * u * u, 0.2 * u * sine(1.15 * u + 0.1 * v));
  };
  const auto look = [](double u, double) { return shaded(waving(0xF2F0EA, u * 0.8), 0.88 + 0.12 * cosine(1.15 * u)); };
  hung_cloth(builder, columns, lod == 0 ? 3 : lod == 1 ? 2 : 1, at, look);
}

/// A string of pennants over a street, 6 m from -X to +X, hanging through by half a metre; its ends are 5 m high.
void bunting(MeshBuilder& builder, int lod) {
  const auto line = [](double x) { return 5.0 - 0.5 * (1 - x * x / 9); };
  const int pieces = lod == 0 ? 8 : 4;
  for (int i = 0; i < pieces && lod < 2; ++i) {
    const double x0 = -3 + 6.0 * i / pieces, x1 = -3 + 6.0 * (i + 1) / pieces;
    bar(builder, {x0, line(x0), 0}, {x1, line(x1), 0}, 0.008, 0.008, 3, paints::matt(0x4A4640));
  }
  constexpr std::array<std::uint32_t, 5> colors{0xD2453C, 0xF2C84B, 0x3F7FBF, 0xF2EEE2, 0x4E9A5B};
  constexpr int pennants = 14;
  for (int i = 0; i < pennants; ++i) {
    const double x0 = -3 + 6.0 * i / pennants + 0.03, x1 = -3 + 6.0 * (i + 1) / pennants - 0.03;
    const double middle = 0.5 * (x0 + x1);
    Paint paint = paints::matt(colors[static_cast<std::size_t>(i) % colors.size()]);
    paint.baked = false;
    Paint tip = paint;
    tip.sway = 70;
    const Corner a{{x0, line(x0), 0}, paint}, b{{x1, line(x1), 0}, paint}, c{{middle, line(middle) - 0.46, 0.04}, tip};
    builder.add({{a, c, b, Corner{}}, 3});
  }
}

/// A cloth of 2 m by 5 m that hangs from a bar on a wall behind it; its upper edge is 5 m high.
void banner(MeshBuilder& builder, int lod) {
  bar(builder, {-1.1, 5.02, 0.12}, {1.1, 5.02, 0.12}, 0.03, 0.03, lod == 0 ? 6 : 3, paints::metal(0x6F6F70));
  const auto at = [](double u, double v) { return dvec3(-1 + 2 * u, 5 * v, 0.12 + 0.05 * (1 - v) * sine(2 * u)); };
  const auto look = [](double u, double v) {
    const bool hem = v > 0.93 || v < 0.07;
    return shaded(waving(hem ? 0xD8D4CA : 0xF2F0EA, (1 - v) * 0.35), 0.93 + 0.07 * cosine(2 * u));
  };
  hung_cloth(builder, lod == 0 ? 8 : lod == 1 ? 4 : 1, lod == 0 ? 5 : 1, at, look);
}

}  // namespace

std::vector<Prop> cloth_props() {
  return {{"flag", {0, 0.03, 0.1}, flag, 0.4},
          {"bunting", {0, 0.02, 0.03}, bunting, 0.4},
          {"banner", {0, 0.03, 0.08}, banner, 0.4}};
}

}  // namespace throng::places
