#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "assets/places/arithmetic.h"
#include "assets/places/paints.h"
#include "assets/places/props.h"
#include "assets/places/shapes.h"

namespace throng::places {
namespace {

/// A street lamp of cast iron, 4 m to the top of its lantern.
void lamp(MeshBuilder& builder, int lod) {
  const Paint iron = paints::metal(0x2F3A36);
  const int sides = lod == 0 ? 10 : 6;
  if (lod == 0) {
    lathe(builder,
          {{0.24, 0},
           {0.24, 0.12},
           {0.17, 0.18},
           {0.15, 0.5},
           {0.18, 0.56},
           {0.1, 0.66},
           {0.07, 0.9},
           {0.05, 2.9},
           {0.09, 2.95},
           {0.05, 3.02},
           {0.04, 3.2},
           {0.14, 3.26},
           {0.14, 3.3}},
          sides, iron);
  } else {
    if (lod == 1) lathe(builder, {{0.22, 0}, {0.15, 0.5}, {0.07, 0.8}, {0.05, 3.2}, {0.14, 3.28}}, sides, iron);
    if (lod == 2) lathe(builder, {{0.2, 0}, {0.07, 0.8}, {0.05, 3.3}}, 3, iron);
  }
  constexpr double eighth = 0.125;
  lathe(builder, {{0.16, 3.3}, {0.25, 3.75}}, 4, paints::lantern, Turned::faceted, eighth);
  lathe(builder, {{0.25, 3.75}, {0.3, 3.77}, {0.08, 3.95}, {0, 4.05}}, 4, iron, Turned::faceted, eighth);
  if (lod > 0) return;
  for (int i = 0; i < 4; ++i) {
    const double t = eighth + 0.25 * i;
    bar(builder, {0.165 * sine(t), 3.3, 0.165 * cosine(t)}, {0.26 * sine(t), 3.76, 0.26 * cosine(t)}, 0.016, 0.016, 4,
        iron, false);
  }
  lathe(builder, {{0.03, 4.0}, {0.05, 4.07}, {0, 4.14}}, 6, iron);
  bar(builder, {-0.4, 2.86, 0}, {0.4, 2.86, 0}, 0.018, 0.018, 5, iron);
}

/// A bench of slats on iron legs: seat 0.44 m high, who sits on it faces +Z.
void bench(MeshBuilder& builder, int lod) {
  constexpr double half = 0.9;
  const Paint wood = paints::timber;
  const Paint iron = paints::metal(0x2B3230);
  const int slats = lod == 0 ? 4 : lod == 1 ? 2 : 1;
  const double depth = 0.44;
  for (int i = 0; i < slats; ++i) {
    const double z0 = -0.22 + depth * i / slats;
    const double z1 = z0 + depth / slats - (lod == 0 ? 0.025 : 0.01);
    box(builder, {-half, 0.405, z0}, {half, 0.44, z1},
        shaded(wood, 0.9 + 0.2 * chance(3, static_cast<std::uint32_t>(i))),
        lod == 2 ? side::front | side::top | side::left | side::right | side::bottom : unsigned{side::all_sides});
  }
  const int backs = lod == 0 ? 3 : 1;
  for (int i = 0; i < backs; ++i) {
    const double y0 = 0.54 + 0.36 * i / backs;
    const double y1 = y0 + 0.36 / backs - 0.03;
    const double z0 = -0.26 - 0.09 * i / backs;
    const double z1 = z0 - 0.09 / backs;
    const Paint slat = shaded(wood, 0.92 + 0.2 * chance(4, static_cast<std::uint32_t>(i)));
    builder.quad({-half, y0, z0}, {half, y0, z0}, {half, y1, z1}, {-half, y1, z1}, slat);
    builder.quad({half, y0, z0 - 0.03}, {-half, y0, z0 - 0.03}, {-half, y1, z1 - 0.03}, {half, y1, z1 - 0.03}, slat);
    builder.quad({-half, y1, z1}, {half, y1, z1}, {half, y1, z1 - 0.03}, {-half, y1, z1 - 0.03}, slat);
    if (lod > 0) continue;
    builder.quad({-half, y0, z0 - 0.03}, {half, y0, z0 - 0.03}, {half, y0, z0}, {-half, y0, z0}, slat);
    for (const double x : {-half, half}) {
      const double sign = x > 0 ? 1 : -1;
      builder.quad({x, y0, z0 - 0.015 + sign * 0.015}, {x, y0, z0 - 0.015 - sign * 0.015},
                   {x, y1, z1 - 0.015 - sign * 0.015}, {x, y1, z1 - 0.015 + sign * 0.015}, slat);
    }
  }
  for (const double x : {-0.7, 0.7}) {
    if (lod >= 2) {
      box(builder, {x - 0.03, 0, -0.2}, {x + 0.03, 0.4, 0.2}, iron,
          side::front | side::back | side::left | side::right);
      continue;
    }
    box(builder, {x - 0.03, 0, 0.14}, {x + 0.03, 0.405, 0.19}, iron,
        side::front | side::back | side::left | side::right);
    bar(builder, {x, 0, -0.3}, {x, 0.42, -0.2}, 0.035, 0.035, 4, iron, false);
    bar(builder, {x, 0.42, -0.22}, {x, 0.92, -0.37}, 0.03, 0.025, 4, iron, false);
    box(builder, {x - 0.025, 0.36, -0.22}, {x + 0.025, 0.405, 0.2}, iron,
        side::front | side::left | side::right | side::bottom);
    if (lod > 0) continue;
    box(builder, {x - 0.03, 0.64, -0.28}, {x + 0.03, 0.68, 0.2}, iron, side::all_sides);
    box(builder, {x - 0.02, 0.44, 0.15}, {x + 0.02, 0.65, 0.18}, iron,
        side::front | side::back | side::left | side::right);
  }
}

/// A round stone bowl of plants.
void planter(MeshBuilder& builder, int lod) {
  const int sides = lod == 0 ? 14 : lod == 1 ? 9 : 5;
  const Paint stone = paints::pale_stone;
  if (lod < 2) {
    lathe(builder,
          {{0.42, 0},
           {0.42, 0.1},
           {0.34, 0.16},
           {0.4, 0.3},
           {0.58, 0.55},
           {0.66, 0.58},
           {0.66, 0.68},
           {0.58, 0.68},
           {0.56, 0.6}},
          sides, stone);
  } else {
    lathe(builder, {{0.4, 0}, {0.64, 0.55}, {0.64, 0.68}}, sides, stone);
  }
  Paint inside = paints::matt(0x2F4A22);
  inside.baked = false;
  lathe(builder, {{0.57, 0.6}, {0.52, 0.76}, {0.34, 0.9}, {0, 0.96}}, sides / 2 + 2, inside, Turned::round);
  const int count = lod == 0 ? 130 : lod == 1 ? 40 : 9;
  for (int i = 0; i < count; ++i) {
    const auto n = static_cast<std::uint32_t>(i);
    const double radius = 0.56 * std::sqrt((i + 0.5) / count);
    const double turn = i * 0.38196601125;
    const double dome = 0.36 * std::sqrt(1 - 0.9 * radius * radius / 0.3136);
    const double y = 0.64 + dome * (0.9 + 0.3 * chance(7, n));
    const dvec3 at(radius * sine(turn), y, radius * cosine(turn));
    const dvec3 normal = glm::normalize(dvec3(at.x, 0.45, at.z));
    const bool flower = n % 4 == 0;
    const double size = (lod == 0 ? 0.075 : lod == 1 ? 0.13 : 0.28) * (flower ? 0.8 : 1.1) * (0.8 + 0.5 * chance(6, n));
    const double lean = chance(8, n);
    const dvec3 u = dvec3(cosine(lean), -0.4 * cosine(lean) * normal.x, sine(lean)) * size;
    const dvec3 v = glm::cross(u, normal) * 0.7;
    constexpr std::array<std::uint32_t, 3> greens{0x557F38, 0x74994A, 0x476B33};
    constexpr std::array<std::uint32_t, 3> petals{0xCC4A5E, 0xE0A83C, 0xE9DCE4};
    Paint leaf = paints::matt(flower ? petals[n / 4 % 3] : greens[n % 3]);
    leaf.sway = 40;
    leaf.baked = false;
    leaf.color *= 0.55 + 0.5 * std::min(1.0, (y - 0.62) / 0.34);
    builder.add({{Corner{at - u, leaf, normal}, Corner{at + v, shaded(leaf, 1.12), normal},
                  Corner{at + u, leaf, normal}, Corner{at - v, shaded(leaf, 0.75), normal}},
                 4});
  }
}

/// Three steps of stone, 6 m wide, that rise away from +Z; the origin is in the middle of what they cover. The second
/// is a seat for people whose feet are before the first.
void steps(MeshBuilder& builder, int lod) {
  constexpr double rise = 0.155;
  constexpr double going = 0.30;
  const double foot = 1.5 * going;
  for (int i = 0; i < 3; ++i) {
    const double z1 = foot - going * i;
    const double y0 = rise * i;
    const Paint stone = shaded(paints::pale_stone, 0.92 + 0.05 * i);
    const int slabs = lod == 0 ? 4 : 1;
    for (int k = 0; k < slabs; ++k) {
      const double x0 = -3 + 6.0 * k / slabs;
      const double x1 = -3 + 6.0 * (k + 1) / slabs;
      const Paint slab = shaded(stone, 0.95 + 0.1 * chance(12, static_cast<std::uint32_t>(i * 4 + k)));
      const double nose = lod == 0 ? 0.03 : 0.0;
      panel(builder, x0, y0, x1, y0 + rise - nose, z1 - nose, slab);
      if (lod == 0)
        builder.quad({x0, y0 + rise - nose, z1 - nose}, {x1, y0 + rise - nose, z1 - nose}, {x1, y0 + rise, z1},
                     {x0, y0 + rise, z1}, slab);
      builder.quad({x0, y0 + rise, z1}, {x1, y0 + rise, z1}, {x1, y0 + rise, z1 - going}, {x0, y0 + rise, z1 - going},
                   slab);
    }
    box(builder, {-3, y0, -foot}, {3, y0 + rise, z1}, stone, side::left | side::right);
  }
  panel(builder, -3, 0, -3, 0, 0, paints::pale_stone);
  builder.faces.pop_back();
  box(builder, {-3, 0, -foot}, {3, 3 * rise, 0}, paints::dark_stone, side::back);
}

void bollard(MeshBuilder& builder, int lod) {
  const Paint iron = paints::metal(0x33393A);
  if (lod == 0) {
    lathe(builder,
          {{0.13, 0},
           {0.13, 0.06},
           {0.1, 0.1},
           {0.085, 0.7},
           {0.11, 0.73},
           {0.11, 0.78},
           {0.07, 0.82},
           {0.09, 0.9},
           {0.06, 0.97},
           {0, 1.0}},
          10, iron);
  } else {
    lathe(builder, {{0.12, 0}, {0.09, 0.85}, {0, 1.0}}, lod == 1 ? 6 : 4, iron);
  }
}

/// A statue of a walking figure in a cloak on a plinth with steps.
void statue(MeshBuilder& builder, int lod) {
  const Paint stone = paints::pale_stone;
  const Paint bronze{.color = rgb(0x5E7F70), .kind = Kind::metal};
  box(builder, {-1.5, 0, -1.5}, {1.5, 0.2, 1.5}, shaded(stone, 0.85));
  box(builder, {-1.2, 0.2, -1.2}, {1.2, 0.4, 1.2}, shaded(stone, 0.92));
  box(builder, {-0.85, 0.4, -0.85}, {0.85, 0.7, 0.85}, stone);
  box(builder, {-0.7, 0.7, -0.7}, {0.7, 2.3, 0.7}, stone, side::front | side::back | side::left | side::right);
  const double r2 = 1.41421356;
  if (lod < 2) {
    lathe(builder, {{0.7 * r2, 2.3}, {0.78 * r2, 2.36}, {0.9 * r2, 2.46}, {0.9 * r2, 2.58}, {0.8 * r2, 2.62}}, 4, stone,
          Turned::faceted, 0.125);
    panel(builder, -0.45, 1.1, 0.45, 1.9, 0.72, paints::metal(0x6E6244));
  }
  box(builder, {-0.8, 2.5, -0.8}, {0.8, 2.62, 0.8}, stone);
  const int sides = lod == 0 ? 12 : lod == 1 ? 8 : 5;
  const Moved up(builder, {0, 2.62, 0}, 0.04);
  {
    const Moved narrow(builder, {0, 0, 0}, 0, {1.0, 1.0, 0.72});
    lathe(builder,
          {{0.47, 0},
           {0.45, 0.15},
           {0.36, 0.7},
           {0.3, 1.1},
           {0.33, 1.35},
           {0.385, 1.6},
           {0.34, 1.74},
           {0.16, 1.83},
           {0.1, 1.88},
           {0.1, 1.98}},
          sides, bronze, Turned::round);
  }
  {
    const Moved head(builder, {0, 1.93, 0.03}, 0, {0.88, 1, 1});
    lathe(builder, {{0.0, 0}, {0.09, 0.03}, {0.125, 0.13}, {0.13, 0.22}, {0.11, 0.3}, {0, 0.36}}, sides, bronze,
          Turned::round);
    lathe(builder, {{0.13, 0.23}, {0.25, 0.25}, {0.14, 0.29}, {0.12, 0.4}, {0, 0.43}}, sides, shaded(bronze, 0.9));
  }
  if (lod >= 2) return;
  bar(builder, {0.33, 1.66, 0}, {0.5, 1.36, 0.12}, 0.12, 0.09, 6, bronze);
  bar(builder, {0.5, 1.36, 0.12}, {0.66, 1.75, 0.34}, 0.09, 0.06, 6, bronze);
  bar(builder, {0.66, 1.72, 0.34}, {0.7, 1.9, 0.38}, 0.06, 0.03, 5, bronze);
  bar(builder, {-0.33, 1.66, 0}, {-0.46, 1.2, 0.08}, 0.12, 0.09, 6, bronze);
  bar(builder, {-0.46, 1.2, 0.08}, {-0.34, 1.0, 0.32}, 0.09, 0.06, 6, bronze);
  box(builder, {-0.42, 0.88, 0.26}, {-0.2, 1.14, 0.38}, bronze, side::all_sides);
  if (lod > 0) return;
  for (int i = 0; i < 7; ++i) {
    const double t = -0.2 + 0.4 * i / 6 + 0.5;
    bar(builder, {0.34 * sine(t), 1.55, 0.26 * cosine(t)}, {0.52 * sine(t), 0.02, 0.44 * cosine(t)}, 0.05, 0.09, 4,
        bronze);
  }
}

/// Two metres of a barrier as they keep crowds off a road.
void barrier(MeshBuilder& builder, int lod) {
  const Paint steel = paints::metal(0xA9AFB2);
  const int sides = lod == 0 ? 6 : 3;
  for (const double y : {0.22, 1.06}) bar(builder, {-0.97, y, 0}, {0.97, y, 0}, 0.022, 0.022, sides, steel);
  for (const double x : {-0.97, 0.97}) {
    bar(builder, {x, 0.1, 0}, {x, 1.08, 0}, 0.022, 0.022, sides, steel);
    if (lod < 2) {
      bar(builder, {x * 0.75, 0.2, 0}, {x * 0.75, 0.02, -0.3}, 0.02, 0.02, 3, steel);
      bar(builder, {x * 0.75, 0.2, 0}, {x * 0.75, 0.02, 0.3}, 0.02, 0.02, 3, steel);
    }
  }
  const int bars = lod == 0 ? 15 : lod == 1 ? 15 : 5;
  for (int i = 1; i < bars; ++i) {
    const double x = -0.97 + 1.94 * i / bars;
    if (lod == 0) {
      bar(builder, {x, 0.22, 0}, {x, 1.06, 0}, 0.009, 0.009, 3, steel);
    } else {
      const double w = lod == 1 ? 0.009 : 0.02;
      panel(builder, x - w, 0.22, x + w, 1.06, 0, steel);
      builder.quad({x + w, 0.22, 0}, {x - w, 0.22, 0}, {x - w, 1.06, 0}, {x + w, 1.06, 0}, steel);
    }
  }
}

}  // namespace

std::vector<Prop> furniture_props() {
  return {{"planter", {0, 0.02, 0.06}, planter, 0.5}, {"lamp", {0, 0.012, 0.03}, lamp, 0.4},
          {"bench", {0, 0.01, 0.03}, bench, 0.4},     {"steps", {0, 0.03}, steps, 0.5},
          {"statue", {0, 0.03, 0.12}, statue, 1.0},   {"bollard", {0, 0.02, 0.04}, bollard, 0.4},
          {"barrier", {0, 0.01, 0.04}, barrier, 0.3}};
}

}  // namespace throng::places
