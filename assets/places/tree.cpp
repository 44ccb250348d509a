#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "assets/places/arithmetic.h"
#include "assets/places/paints.h"
#include "assets/places/props.h"
#include "assets/places/shapes.h"

namespace throng::places {
namespace {

/// A round mass of leaves.
struct Lobe {
  dvec3 centre;
  dvec3 radius;
};

/// How a kind of tree looks.
struct Species {
  std::vector<Lobe> lobes = {};
  double trunk_height = 3;
  double trunk_radius = 0.17;
  dvec3 bark, light, dark;
  double leaf = 0.34;
  std::uint32_t seed = 1;
};

struct Bounds {
  double low = 1e9, high = -1e9;
};

Bounds bounds_of(const Species& species) {
  Bounds b;
  for (const Lobe& lobe : species.lobes) {
    b.low = std::min(b.low, lobe.centre.y - lobe.radius.y);
    b.high = std::max(b.high, lobe.centre.y + lobe.radius.y);
  }
  return b;
}

/// Light leaves above and outside, dark ones below and inside.
Paint leaf_paint(const Species& species, const Bounds& bounds, dvec3 at, double depth, double dice) {
  const double height = (at.y - bounds.low) / (bounds.high - bounds.low);
  const double share = std::min(1.0, std::max(0.0, 0.15 + 0.7 * height + 0.35 * (dice - 0.5) - 0.35 * depth));
  Paint paint;
  paint.color = species.dark + (species.light - species.dark) * share;
  paint.color *= 0.85 + 0.3 * dice;
  paint.sway = static_cast<int>(60 + 150 * std::min(1.0, height));
  paint.baked = false;
  return paint;
}

dvec3 spiral(int i, int count) {
  const double y = 1 - (2.0 * i + 1) / count;
  const double radius = std::sqrt(1 - y * y);
  const double turn = i * 0.38196601125;
  return {radius * cosine(turn), y, radius * sine(turn)};
}

/// The dark inside of a lobe, or all of it from afar: a ball of some faces, uneven.
void ball(MeshBuilder& builder, const Species& species, const Bounds& bounds, const Lobe& lobe, int sides, int rings,
          double size, double depth, std::uint32_t seed) {
  const auto corner = [&](int i, int j) {
    const double polar = 0.5 * j / rings;
    const double turn = static_cast<double>(i % sides) / sides + 0.5 * j / sides;
    const auto number = static_cast<std::uint32_t>(j == 0 ? 900 : j == rings ? 901 : j * 32 + i % sides);
    const dvec3 way(sine(polar) * sine(turn), cosine(polar), sine(polar) * cosine(turn));
    const double bulge = size * (0.88 + 0.24 * chance(seed, number));
    Corner made;
    made.position = lobe.centre + lobe.radius * way * bulge;
    made.normal = glm::normalize(way / lobe.radius);
    made.paint = leaf_paint(species, bounds, made.position, depth, chance(seed, number + 400));
    return made;
  };
  for (int j = 0; j < rings; ++j) {
    for (int i = 0; i < sides; ++i) {
      const Corner a = corner(i, j), b = corner(i, j + 1), c = corner(i + 1, j + 1), d = corner(i + 1, j);
      if (j == 0) {
        builder.add({{a, b, c, Corner{}}, 3});
      } else if (j == rings - 1) {
        builder.add({{a, b, d, Corner{}}, 3});
      } else {
        builder.add({{a, b, c, d}, 4});
      }
    }
  }
}

/// A clump of leaves: a bent leaf-shaped card on the outside of a lobe.
void clump(MeshBuilder& builder, const Species& species, const Bounds& bounds, const Lobe& lobe, int i, int count,
           std::uint32_t seed, double size) {
  const auto n = static_cast<std::uint32_t>(i);
  const dvec3 way =
      glm::normalize(spiral(i, count) + 0.25 * dvec3(chance(seed, n + 1000) - 0.5, chance(seed, n + 2000) - 0.5,
                                                     chance(seed, n + 3000) - 0.5));
  const double out = 0.86 + 0.24 * chance(seed, n + 5000);
  const dvec3 at = lobe.centre + lobe.radius * way * out;
  const dvec3 facing = glm::normalize(
      way + 0.9 * dvec3(chance(seed, n + 11) - 0.5, chance(seed, n + 4111) - 0.3, chance(seed, n + 6111) - 0.5));
  const double turn = chance(seed, n + 7000);
  const dvec3 helper = facing.y > 0.9 || facing.y < -0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 u0 = glm::normalize(glm::cross(helper, facing));
  const dvec3 v0 = glm::cross(facing, u0);
  const dvec3 u = u0 * cosine(turn) + v0 * sine(turn);
  const dvec3 v = glm::cross(facing, u);
  const double length = size * (0.75 + 0.6 * chance(seed, n + 8000));
  const Paint paint = leaf_paint(species, bounds, at, 0.15 - 0.5 * (out - 0.86), chance(seed, n + 9000));
  const dvec3 normal = glm::normalize(way / lobe.radius * 0.75 / glm::length(way / lobe.radius) + facing * 0.4);
  const auto corner = [&](dvec3 place, double shade) { return Corner{place, shaded(paint, shade), normal}; };
  const dvec3 bend = -facing * (0.22 * length);
  builder.add({{corner(at - u * length + bend, 0.8), corner(at - v * (length * 0.62), 0.95),
                corner(at + u * length + bend, 1.1), corner(at + v * (length * 0.62), 1.0)},
               4});
}

void trunk(MeshBuilder& builder, const Species& species, int lod) {
  const Paint bark{.color = species.bark};
  const int sides = lod == 0 ? 8 : lod == 1 ? 6 : 4;
  const double r = species.trunk_radius;
  const double h = species.trunk_height;
  if (lod < 2) bar(builder, {0, -0.05, 0}, {0.02, 0.35, 0.01}, r * 1.7, r * 1.1, sides, bark);
  bar(builder, lod < 2 ? dvec3(0.02, 0.35, 0.01) : dvec3(0, 0, 0), {0.08, h, 0.05}, r * 1.1, r * 0.75, sides, bark);
  if (lod >= 2) return;
  for (std::size_t i = 0; i < species.lobes.size(); ++i) {
    if (lod == 1 && i % 2 == 1) continue;
    const dvec3 from(0.05, h * (0.82 + 0.03 * static_cast<double>(i % 5)), 0.03);
    bar(builder, from, species.lobes[i].centre, r * 0.55, r * 0.15, lod == 0 ? 5 : 3, bark);
  }
}

void grow(MeshBuilder& builder, const Species& species, int lod) {
  const Bounds bounds = bounds_of(species);
  trunk(builder, species, lod);
  std::uint32_t seed = species.seed * 1000;
  for (const Lobe& lobe : species.lobes) {
    ++seed;
    if (lod == 3) {
      continue;
    }
    const double area = lobe.radius.x * lobe.radius.y;
    if (lod == 2) {
      ball(builder, species, bounds, lobe, 5, 3, 1.08, 0.0, seed);
      continue;
    }
    ball(builder, species, bounds, lobe, lod == 0 ? 7 : 5, lod == 0 ? 4 : 3, lod == 0 ? 0.84 : 0.92,
         lod == 0 ? 0.55 : 0.3, seed);
    const int count = static_cast<int>((lod == 0 ? 52 : 14) * area);
    for (int i = 0; i < count; ++i)
      clump(builder, species, bounds, lobe, i, count, seed, species.leaf * (lod == 0 ? 1.0 : 1.55));
  }
  if (lod < 3) return;
  dvec3 low(1e9), high(-1e9);
  for (const Lobe& lobe : species.lobes) {
    low = glm::min(low, lobe.centre - lobe.radius);
    high = glm::max(high, lobe.centre + lobe.radius);
  }
  ball(builder, species, bounds, {0.5 * (low + high), 0.5 * (high - low)}, 6, 3, 0.97, 0.1, seed);
}

/// A broad crown, as of a plane tree.
void tree_a(MeshBuilder& builder, int lod) {
  Species s{.trunk_height = 3.2,
            .trunk_radius = 0.2,
            .bark = rgb(0x8A7B66),
            .light = rgb(0x9DB45A),
            .dark = rgb(0x33491F),
            .leaf = 0.3,
            .seed = 1};
  s.lobes = {{{0.1, 6.9, 0}, {1.6, 1.3, 1.6}},      {{1.5, 5.7, 0.4}, {1.35, 1.1, 1.3}},
             {{-1.4, 5.6, 0.7}, {1.4, 1.15, 1.3}},  {{0.2, 5.4, -1.5}, {1.4, 1.15, 1.3}},
             {{-0.2, 5.2, 1.6}, {1.25, 1.0, 1.15}}, {{1.0, 4.5, -0.7}, {1.2, 0.85, 1.2}},
             {{-0.9, 4.4, -0.5}, {1.2, 0.85, 1.2}}};
  grow(builder, s, lod);
}

/// A tall oval crown, as of a lime tree.
void tree_b(MeshBuilder& builder, int lod) {
  Species s{.trunk_height = 2.7,
            .trunk_radius = 0.15,
            .bark = rgb(0x6B5B49),
            .light = rgb(0x7FA04A),
            .dark = rgb(0x2A4420),
            .leaf = 0.26,
            .seed = 2};
  s.lobes = {{{0, 8.0, 0}, {0.85, 1.1, 0.85}},       {{0.35, 6.7, 0.25}, {1.15, 1.15, 1.1}},
             {{-0.4, 6.2, -0.3}, {1.2, 1.15, 1.15}}, {{0.3, 5.1, -0.4}, {1.35, 1.1, 1.3}},
             {{-0.3, 4.6, 0.45}, {1.3, 1.05, 1.3}},  {{0.25, 3.8, 0.1}, {1.15, 0.8, 1.15}}};
  grow(builder, s, lod);
}

/// A small, round tree of warm leaves, as of a maple in its pot or its square of earth.
void tree_c(MeshBuilder& builder, int lod) {
  Species s{.trunk_height = 2.2,
            .trunk_radius = 0.12,
            .bark = rgb(0x5F5146),
            .light = rgb(0xC7B04C),
            .dark = rgb(0x5C6022),
            .leaf = 0.25,
            .seed = 3};
  s.lobes = {{{0, 5.2, 0}, {1.1, 0.95, 1.1}},
             {{0.8, 4.3, 0.3}, {1.0, 0.85, 1.0}},
             {{-0.75, 4.3, 0.35}, {1.0, 0.85, 1.0}},
             {{0.05, 4.1, -0.8}, {1.0, 0.85, 1.0}},
             {{0, 3.5, 0.4}, {1.0, 0.7, 1.0}}};
  grow(builder, s, lod);
}

}  // namespace

std::vector<Prop> tree_props() {
  const std::vector<double> errors{0, 0.12, 0.3, 0.7};
  return {{"tree_a", errors, tree_a, 0.6}, {"tree_b", errors, tree_b, 0.6}, {"tree_c", errors, tree_c, 0.6}};
}

}  // namespace throng::places
