#include <algorithm>

#include <glm/geometric.hpp>

#include "assets/places/arithmetic.h"
#include "assets/places/house.h"
#include "assets/places/paints.h"
#include "assets/places/props.h"

namespace throng::places {
namespace {

constexpr double arcade_half = 3.0;
constexpr double wall_depth = 0.7;
constexpr double walk_depth = 4.6;  ///< from the front to the shops behind the walk
constexpr double arcade_spring = 3.3;
constexpr double first_floor = 6.1;
constexpr double eaves_y = 16.2;
constexpr double arcade_house = 9.0;
const std::vector<double> arcade_errors{0, 0.035, 0.1, 0.3};

Arch front_arch(int lod) { return {0, 2.0, arcade_spring, 2.0, lod == 0 ? 10 : lod == 1 ? 6 : 4}; }

/// A pier with plinth and capital, from x0 to x1.
void pier(MeshBuilder& builder, double x0, double x1, int lod) {
  const Paint stone = paints::limestone;
  if (lod >= 2) {
    panel(builder, x0, 0, x1, arcade_spring, 0, stone);
    return;
  }
  panel(builder, x0, 0.5, x1, arcade_spring, 0, stone);
  const bool inner_right = x1 < 0;
  const double in0 = inner_right ? x0 : x0 - 0.1;
  const double in1 = inner_right ? x1 + 0.1 : x1;
  const unsigned inner = inner_right ? side::right : side::left;
  box(builder, {in0, 0, -wall_depth - 0.08}, {in1, 0.45, 0.1}, shaded(stone, 0.85),
      side::front | inner | side::top | side::back);
  box(builder, {in0, arcade_spring - 0.28, -wall_depth - 0.08}, {in1, arcade_spring - 0.02, 0.1}, paints::pale_stone,
      side::front | inner | side::top | side::bottom | side::back);
  if (lod > 0) return;
  // A half column before the pier carries the course above.
  const double middle = inner_right ? x0 : x1;
  const double width = 0.22;
  const double c0 = inner_right ? middle : middle - width;
  box(builder, {c0, 0.45, 0}, {c0 + width, first_floor - 0.3, 0.16}, paints::pale_stone, side::front | inner);
  box(builder, {inner_right ? c0 : c0 - 0.08, 0, 0}, {inner_right ? c0 + width + 0.08 : c0 + width, 0.6, 0.24},
      shaded(paints::pale_stone, 0.85), side::front | inner | side::top);
  box(builder, {inner_right ? c0 : c0 - 0.08, first_floor - 0.62, 0},
      {inner_right ? c0 + width + 0.08 : c0 + width, first_floor - 0.3, 0.24}, paints::pale_stone,
      side::front | inner | side::bottom);
}

/// The vault over the walk: two barrels that cross.
void vault(MeshBuilder& builder, int pieces) {
  const double z0 = -walk_depth;
  const double z1 = -wall_depth;
  const double half_depth = 0.5 * (z1 - z0);
  constexpr double rise = 2.1;
  const auto at = [&](int i, int j) {
    const double u = 0.5 - 0.5 * i / pieces;
    const double v = 0.5 - 0.5 * j / pieces;
    const double height = std::max(sine(u), sine(v));
    return dvec3(arcade_half * cosine(u), arcade_spring + rise * height, 0.5 * (z0 + z1) + half_depth * cosine(v));
  };
  const Paint plaster = paints::matt(0xE9DFCB);
  for (int i = 0; i < pieces; ++i) {
    for (int j = 0; j < pieces; ++j) {
      const dvec3 a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      const bool rising = (i < pieces / 2) == (j < pieces / 2);
      if (rising) {
        builder.triangle(a, b, c, plaster);
        builder.triangle(a, c, d, plaster);
      } else {
        builder.triangle(a, b, d, plaster);
        builder.triangle(b, c, d, plaster);
      }
    }
  }
}

/// The shops behind the walk.
void walk_back(MeshBuilder& builder, int lod) {
  const Paint plaster = paints::matt(0xD9C6A4);
  const Moved moved(builder, {0, 0, -walk_depth});
  if (lod >= 2) {
    panel(builder, -arcade_half, 0, arcade_half, arcade_spring + 2.1, 0, shaded(plaster, 0.6));
    panel(builder, -1.6, 0.5, 1.6, 2.9, 0.05, paints::glass(200));
    return;
  }
  panel(builder, -arcade_half, 0, -1.7, 3.2, 0, plaster);
  panel(builder, 1.7, 0, arcade_half, 3.2, 0, plaster);
  panel(builder, -arcade_half, 3.2, arcade_half, arcade_spring + 2.1, 0, plaster);
  shop_front(builder, -1.7, 1.7, 0, 3.2, 0.3, paints::matt(0x4A3326), false, lod, 71);
}

void open_front(MeshBuilder& builder, int lod) {
  const Arch arch = front_arch(lod);
  const Paint stone = paints::limestone;
  pier(builder, -arcade_half, -arch.half, lod);
  pier(builder, arch.half, arcade_half, lod);
  wall_over_arch(builder, arch, first_floor, 0, stone);
  for (const double side : {-1.0, 1.0}) {
    const double x0 = side < 0 ? -arcade_half : arch.half;
    panel(builder, x0, arcade_spring, x0 + 1.0, first_floor, 0, stone);
  }
  if (lod < 3) arch_reveal(builder, arch, 0, 0, -wall_depth, shaded(stone, 0.95));
  if (lod < 2) arch_ring(builder, arch, 0.38, 0, 0.07, paints::pale_stone, lod == 0);
  if (lod > 1) return;
  // The inner face of the wall.
  const Moved turned(builder, {0, 0, -wall_depth}, 0.5);
  wall_over_arch(builder, arch, arcade_spring + 2.1, 0, stone);
  panel(builder, -arcade_half, 0, -arch.half, arcade_spring + 2.1, 0, stone);
  panel(builder, arch.half, 0, arcade_half, arcade_spring + 2.1, 0, stone);
}

WindowStyle palace_window(double height, WindowStyle::Head head) {
  return {.head = head,
          .width = 1.2,
          .height = height,
          .reveal = 0.26,
          .rows = 3,
          .trim = paints::pale_stone,
          .frame = paints::matt(0x5B4634)};
}

void upper_front(MeshBuilder& builder, int lod, std::uint32_t seed) {
  Front front{.windows = {-1.5, 1.5}, .top = eaves_y, .wall = paints::tinted(0xE6D2AC), .seed = seed};
  front.storeys = {{first_floor, 3.9, 0.7, palace_window(2.4, WindowStyle::Head::pediment)},
                   {10.0, 3.4, 0.8, palace_window(2.0, WindowStyle::Head::lintel)},
                   {13.4, 2.8, 0.75, palace_window(1.3, WindowStyle::Head::lintel)}};
  front_wall(builder, front, lod);
  band(builder, -arcade_half, arcade_half, first_floor - 0.3, 0.42, 0.26, paints::pale_stone, lod);
  if (lod < 3) band(builder, -arcade_half, arcade_half, 9.9, 0.25, 0.12, paints::pale_stone, lod);
  cornice(builder, -arcade_half, arcade_half, eaves_y, paints::pale_stone, lod, true);
}

void arcade_bay(MeshBuilder& builder, int lod) {
  open_front(builder, lod);
  upper_front(builder, lod, 81);
  if (lod < 3) walk_back(builder, lod);
  if (lod == 3) panel(builder, -arcade_half, 0, arcade_half, arcade_spring + 2.1, -2.5, paints::matt(0x5B5142));
  if (lod < 2) vault(builder, lod == 0 ? 6 : 4);
  if (lod == 2) {
    box(builder, {-arcade_half, arcade_spring + 1.9, -walk_depth}, {arcade_half, arcade_spring + 2.1, -wall_depth},
        paints::matt(0x9E9584), side::bottom);
  }
  const Paint side = shaded(paints::tinted(0xE6D2AC), 0.85);
  closed_box(builder, 6, first_floor, eaves_y + 0.75, arcade_house, side, shaded(side, 0.95));
  {
    const Moved behind(builder, {0, 0, -walk_depth});
    closed_box(builder, 6, 0, first_floor, arcade_house - walk_depth, side, shaded(side, 0.95));
  }
  gable_roof(builder,
             {.front_z = 0.5,
              .back_z = -arcade_house,
              .eaves = eaves_y + 0.75,
              .ridge = eaves_y + 3.4,
              .tile = paints::roof_tile,
              .seed = 17},
             lod, side);
  chimney(builder, {1.9, eaves_y + 2.2, -2.6}, 1.9, side, lod);
}

/// A pavilion that ends an arcade, or stands where two meet: open on three sides below, taller than what it joins.
void arcade_corner(MeshBuilder& builder, int front_lod) {
  constexpr double half = arcade_half;
  for (int side = 0; side < 4; ++side) {
    const Moved turned(builder, {0, 0, -half}, 0.25 * side);
    const Moved out(builder, {0, 0, half});
    const int lod = side == 0 || front_lod > 1 ? front_lod : front_lod + 1;
    if (side == 2) {
      panel(builder, -half, 0, half, eaves_y + 2.2, 0, shaded(paints::limestone, 0.85));
      cornice(builder, -half - 0.4, half + 0.4, eaves_y + 2.2, paints::pale_stone, lod, false);
      continue;
    }
    open_front(builder, lod);
    Front front{.windows = {-1.5, 1.5},
                .top = eaves_y + 2.2,
                .wall = paints::limestone,
                .seed = 91U + static_cast<std::uint32_t>(side)};
    front.storeys = {{first_floor, 3.9, 0.7, palace_window(2.4, WindowStyle::Head::pediment)},
                     {10.0, 3.8, 0.8, palace_window(2.2, WindowStyle::Head::pediment)},
                     {13.8, 4.6, 1.0, palace_window(2.4, WindowStyle::Head::round)}};
    front_wall(builder, front, lod);
    band(builder, -half, half, first_floor - 0.3, 0.42, 0.26, paints::pale_stone, lod);
    if (lod < 3) band(builder, -half, half, 13.6, 0.3, 0.2, paints::pale_stone, lod);
    cornice(builder, -half - 0.4, half + 0.4, eaves_y + 2.2, paints::pale_stone, lod, true);
  }
  const int lod = front_lod;
  if (lod < 2)
    box(builder, {-half, arcade_spring + 2.1, -2 * half}, {half, arcade_spring + 2.2, 0}, paints::matt(0xE9DFCB),
        side::bottom);
  const Moved roof(builder, {0, eaves_y + 2.9, -half});
  const double r = 1.41421356 * (half + 0.5);
  lathe(builder, {{r, 0}, {r * 0.55, 1.6}, {0, 3.6}}, 4, paints::roof_tile, Turned::faceted, 0.125);
  if (lod < 2) lathe(builder, {{0.25, 3.4}, {0.32, 3.75}, {0.1, 4.1}, {0.04, 5.2}, {0, 5.3}}, 6, paints::copper);
}

}  // namespace

std::vector<Prop> arcade_props() {
  return {{"arcade_bay", arcade_errors, arcade_bay, 2.2}, {"arcade_corner", arcade_errors, arcade_corner, 2.2}};
}

}  // namespace throng::places
