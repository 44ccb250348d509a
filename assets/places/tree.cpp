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
  paint.tinted = 255;
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

/// Says where a clump of leaves sits and how it is turned.
struct Clump {
  dvec3 at, facing, u, v, normal;
  double length = 0;
  Paint paint = {};
};

Clump clump_at(const Species& species, const Bounds& bounds, const Lobe& lobe, int i, int count, std::uint32_t seed,
               double size) {
  const auto n = static_cast<std::uint32_t>(i);
  const auto dice = [&](std::uint32_t what) { return chance(seed, n + 1000 * what) - 0.5; };
  Clump clump;
  const dvec3 way = glm::normalize(spiral(i, count) + 0.3 * dvec3(dice(1), dice(2), dice(3)));
  const double out = 0.92 + 0.24 * (dice(4) + 0.5);
  clump.at = lobe.centre + lobe.radius * way * out;
  clump.facing = glm::normalize(way + 1.2 * dvec3(dice(5), dice(6) + 0.2, dice(7)));
  const double turn = dice(8);
  const dvec3 helper = clump.facing.y > 0.9 || clump.facing.y < -0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 u = glm::normalize(glm::cross(helper, clump.facing));
  const dvec3 v = glm::cross(clump.facing, u);
  clump.u = u * cosine(turn) + v * sine(turn);
  clump.v = glm::cross(clump.facing, clump.u);
  clump.length = size * (1.05 + 0.7 * dice(9));
  clump.paint = leaf_paint(species, bounds, clump.at, 1.2 * (0.98 - out), dice(10) + 0.5);
  // Soft light over the whole crown, a little of each leaf's own.
  const dvec3 round = glm::normalize(way / lobe.radius);
  const dvec3 crown = glm::normalize(clump.at - dvec3(0, 0.5 * (bounds.low + bounds.high), 0));
  clump.normal = glm::normalize(round * 0.5 + crown * 0.4 + clump.facing * 0.25);
  return clump;
}

/// A card in the shape of a leaf, its ends bent back a little.
void leaf_card(MeshBuilder& builder, const Clump& clump) {
  const auto corner = [&](dvec3 place, double shade) {
    return Corner{place, shaded(clump.paint, shade), clump.normal};
  };
  const dvec3 along = clump.u * clump.length;
  const dvec3 across = clump.v * (0.62 * clump.length);
  const dvec3 bend = clump.facing * (-0.16 * clump.length);
  builder.add({{corner(clump.at - along + bend, 0.8), corner(clump.at - across * 1.1 + along * 0.2, 0.98),
                corner(clump.at + along + bend, 1.12), corner(clump.at + across - along * 0.15, 1.0)},
               4});
}

void trunk(MeshBuilder& builder, const Species& species, int lod) {
  const Paint bark{.color = species.bark};
  const int sides = lod == 0 ? 8 : lod == 1 ? 6 : lod == 2 ? 4 : 3;
  const double r = species.trunk_radius;
  const double h = species.trunk_height;
  if (lod < 2) bar(builder, {0, 0, 0}, {0.02, 0.35, 0.01}, r * 1.7, r * 1.1, sides, bark);
  if (lod == 3) {
    bar(builder, {0, 0, 0}, {0.1, h * 1.35, 0.05}, r * 1.1, r * 0.7, sides, bark);
    return;
  }
  bar(builder, lod < 2 ? dvec3(0.02, 0.35, 0.01) : dvec3(0, 0, 0), {0.08, h, 0.05}, r * 1.1, r * 0.75, sides, bark);
  if (lod >= 2) {
    bar(builder, {0.08, h, 0.05}, species.lobes.front().centre, r * 0.75, r * 0.4, 4, bark);
    return;
  }
  for (std::size_t i = 0; i < species.lobes.size(); ++i) {
    if (lod == 1 && i % 2 == 1) continue;
    const dvec3 from(0.05, h * (0.82 + 0.03 * static_cast<double>(i % 5)), 0.03);
    bar(builder, from, species.lobes[i].centre, r * 0.55, r * 0.15, lod == 0 ? 5 : 3, bark);
  }
}

/// All lobes as two balls.
void far_crown(MeshBuilder& builder, const Species& species, const Bounds& bounds) {
  constexpr std::size_t balls = 2;
  const std::size_t count = species.lobes.size();
  for (std::size_t i = 0; i < balls; ++i) {
    dvec3 low(1e9), high(-1e9);
    for (std::size_t k = i * count / balls; k < (i + 1) * count / balls; ++k) {
      low = glm::min(low, species.lobes[k].centre - species.lobes[k].radius);
      high = glm::max(high, species.lobes[k].centre + species.lobes[k].radius);
    }
    ball(builder, species, bounds, {0.5 * (low + high), 0.5 * (high - low)}, 5, 3, 1.0, 0.2,
         species.seed * 50 + static_cast<std::uint32_t>(i));
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
      ball(builder, species, bounds, lobe, 5, 3, 0.95, 0.4, seed);
    } else {
      ball(builder, species, bounds, lobe, lod == 0 ? 7 : 5, lod == 0 ? 4 : 3, 0.84, 0.7, seed);
    }
    const int count = static_cast<int>((lod == 0 ? 100 : lod == 1 ? 34 : 6) * area);
    const double size = species.leaf * (lod == 0 ? 1.0 : lod == 1 ? 1.55 : 2.4);
    for (int i = 0; i < count; ++i) leaf_card(builder, clump_at(species, bounds, lobe, i, count, seed, size));
  }
  if (lod == 3) far_crown(builder, species, bounds);
}

/// A broad crown, as of a plane tree.
void tree_a(MeshBuilder& builder, int lod) {
  Species s{.trunk_height = 3.2,
            .trunk_radius = 0.2,
            .bark = rgb(0x8A7B66),
            .light = rgb(0x9DB45A),
            .dark = rgb(0x33491F),
            .leaf = 0.195,
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
            .leaf = 0.18,
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
            .light = rgb(0xC2B055),
            .dark = rgb(0x565A26),
            .leaf = 0.165,
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
  const std::vector<double> errors{0, 0.03, 0.1, 0.3};
  return {{"tree_a", errors, tree_a, 0.6}, {"tree_b", errors, tree_b, 0.6}, {"tree_c", errors, tree_c, 0.6}};
}

}  // namespace throng::places
