#include "assets/places/arithmetic.h"
#include "assets/places/house.h"
#include "assets/places/paints.h"
#include "assets/places/props.h"

namespace throng::places {
namespace {

constexpr double bay = 3.0;  ///< half a bay's width
constexpr double house_depth = 8.0;
const std::vector<double> facade_errors{0, 0.035, 0.1, 0.3};

WindowStyle classical(double height, WindowStyle::Head head) {
  return {.head = head, .width = 1.15, .height = height, .trim = paints::pale_stone, .frame = paints::white_paint};
}

void facade_a(MeshBuilder& builder, int lod) {
  const Paint stone = paints::limestone;
  ground_floor(builder, 4.2, stone, paints::matt(0x2F4A3C), true, lod, 11);
  Front front{.windows = {-1.45, 1.45}, .top = 14.3, .wall = paints::stucco, .seed = 21};
  front.storeys = {{4.2, 3.8, 0.55, classical(2.35, WindowStyle::Head::pediment)},
                   {8.0, 3.3, 0.85, classical(1.85, WindowStyle::Head::lintel)},
                   {11.3, 3.0, 0.8, classical(1.45, WindowStyle::Head::lintel)}};
  front.storeys[0].window.railing = true;
  front_wall(builder, front, lod);
  band(builder, -bay, bay, 4.1, 0.3, 0.16, paints::pale_stone, lod);
  if (lod < 3) band(builder, -bay, bay, 7.9, 0.2, 0.1, paints::pale_stone, lod);
  if (lod == 0) {
    for (int i = 0; i < 8; ++i) {
      const double y = 4.5 + 1.2 * i;
      const double wide = i % 2 == 0 ? 0.46 : 0.3;
      box(builder, {-bay, y, 0}, {-bay + wide, y + 1.1, 0.05}, paints::pale_stone, side::front | side::right);
      box(builder, {bay - wide, y, 0}, {bay, y + 1.1, 0.05}, paints::pale_stone, side::front | side::left);
    }
  }
  cornice(builder, -bay, bay, 14.3, paints::pale_stone, lod, true);
  closed_box(builder, 6, 0, 14.95, house_depth, shaded(paints::stucco, 0.85), shaded(paints::stucco, 0.8));
  mansard_roof(
      builder,
      {.front_z = 0.1, .back_z = -house_depth, .eaves = 14.95, .ridge = 18.2, .tile = paints::slate, .seed = 3}, lod,
      shaded(paints::stucco, 0.85));
  for (const double x : {-1.45, 1.45})
    dormer(builder, {x, 15.2, -0.05}, 1.3, 1.5, 1.2, paints::pale_stone, paints::slate, lod, x > 0 ? 4U : 5U);
  chimney(builder, {-2.4, 17.6, -5.2}, 2.0, paints::brick, lod);
  if (lod < 3) awning(builder, -2.3, 2.3, 3.55, 1.35, paints::matt(0xB23A34), paints::matt(0xF2E6D0), 10, lod);
}

WindowStyle shuttered(double height, std::uint32_t color) {
  return {.head = WindowStyle::Head::plain,
          .width = 1.05,
          .height = height,
          .rows = 2,
          .trim = paints::pale_stone,
          .frame = paints::white_paint,
          .surround = false,
          .shutters = true,
          .shutter = paints::matt(color)};
}

void facade_b(MeshBuilder& builder, int lod) {
  ground_floor(builder, 3.9, paints::pale_stone, paints::matt(0x5B3B2A), false, lod, 31);
  Front front{.windows = {-1.5, 1.5}, .top = 15.9, .wall = shaded(paints::tinted(0xE8C9A0), 1.0), .seed = 22};
  constexpr std::uint32_t green = 0x4F7A6B;
  front.storeys = {{3.9, 3.2, 0.95, shuttered(1.75, green)},
                   {7.1, 3.1, 0.95, shuttered(1.7, green)},
                   {10.2, 3.0, 0.95, shuttered(1.6, green)},
                   {13.2, 2.7, 0.9, shuttered(1.2, green)}};
  for (const int n : {0, 2}) front.storeys[static_cast<std::size_t>(n)].window.flowers = true;
  front_wall(builder, front, lod);
  band(builder, -bay, bay, 3.75, 0.25, 0.12, paints::pale_stone, lod);
  closed_box(builder, 6, 0, 15.9, house_depth, shaded(front.wall, 0.85), shaded(front.wall, 0.8));
  gable_roof(
      builder,
      {.front_z = 0.75, .back_z = -house_depth, .eaves = 15.7, .ridge = 18.0, .tile = paints::roof_tile, .seed = 8},
      lod, shaded(front.wall, 0.85));
  if (lod == 0) {
    for (int i = 0; i < 10; ++i) {
      const double x = -bay + 0.3 + i * 0.6;
      box(builder, {x - 0.06, 15.4, 0}, {x + 0.06, 15.6, 0.65}, shaded(paints::timber, 0.7),
          side::front | side::left | side::right | side::bottom);
    }
  }
  chimney(builder, {1.6, 17.0, -2.4}, 1.9, shaded(front.wall, 0.9), lod);
  if (lod < 3) awning(builder, -2.35, 2.35, 3.3, 1.5, paints::matt(0x2F5D4A), paints::matt(0xEDE3CC), 12, lod);
}

WindowStyle brick_window(double height) {
  return {.head = WindowStyle::Head::round,
          .width = 1.15,
          .height = height,
          .rows = 3,
          .trim = paints::limestone,
          .frame = paints::matt(0x37423C)};
}

/// A gable that steps up to the middle and hides the roof behind it.
void stepped_gable(MeshBuilder& builder, double foot, const Paint& wall, int lod) {
  constexpr int steps = 4;
  const Paint cap = paints::limestone;
  for (int i = 0; i < steps; ++i) {
    const double half = bay - 0.68 * i;
    const double over = i == 0 ? 0.0 : 0.06;
    const double y0 = foot + 0.95 * i;
    const double y1 = y0 + 0.95;
    if (lod == 3) panel(builder, -half, y0, half, y1 + 0.1, 0, wall);
    if (lod == 3) continue;
    box(builder, {-half, y0, -0.4}, {half, y1, 0}, wall, side::front | side::back | side::left | side::right);
    if (lod < 2) box(builder, {-half - over, y1 - 0.02, -0.46}, {half + over, y1 + 0.1, 0.08}, cap, side::all_sides);
    if (lod >= 2) box(builder, {-half, y1 - 0.02, -0.4}, {half, y1 + 0.1, 0.02}, cap, side::top | side::front);
  }
}

void facade_c(MeshBuilder& builder, int lod) {
  ground_floor(builder, 4.0, paints::dark_stone, paints::matt(0x26364F), true, lod, 41);
  const double top = 11.0;
  Front front{.windows = {-1.5, 1.5}, .top = top, .wall = paints::brick, .seed = 23};
  front.storeys = {{4.0, 3.6, 0.7, brick_window(2.2)}, {7.6, 3.4, 0.7, brick_window(2.0)}};
  front_wall(builder, front, lod);
  band(builder, -bay, bay, 3.9, 0.25, 0.14, paints::limestone, lod);
  if (lod < 3) band(builder, -bay, bay, 7.5, 0.22, 0.08, paints::limestone, lod);
  band(builder, -bay, bay, top - 0.2, 0.25, 0.12, paints::limestone, lod);
  stepped_gable(builder, top, paints::brick, lod);
  const Moved up(builder, {0, top, 0.003});
  window(builder, 0, 0.55, brick_window(1.7), lod == 3 ? 3 : 2, 77);
  const Moved down(builder, {0, -top, -0.003});
  closed_box(builder, 6, 0, top, house_depth, shaded(paints::brick, 0.85), shaded(paints::brick, 0.8));
  const Moved turned(builder, {0, 0, -house_depth / 2 - 0.2}, 0.25);
  gable_roof(builder,
             {.x0 = -house_depth / 2 + 0.2,
              .x1 = house_depth / 2 - 0.2,
              .front_z = 3.0,
              .back_z = -3.0,
              .eaves = top,
              .ridge = top + 3.4,
              .tile = shaded(paints::roof_tile, 0.75),
              .seed = 14},
             lod, shaded(paints::brick, 0.85));
}

void facade_c_whole(MeshBuilder& builder, int lod) {
  facade_c(builder, lod);
  chimney(builder, {-2.3, 13.0, -5.4}, 1.8, paints::brick, lod);
  if (lod < 3) awning(builder, -2.3, 2.3, 3.4, 1.3, paints::matt(0x27406B), paints::matt(0xF0E8D8), 8, lod);
}

/// The last house of a row: fronts on three sides under a roof of four slopes.
void facade_corner(MeshBuilder& builder, int front_lod) {
  constexpr double half = 3.0;
  const Paint wall = paints::stucco;
  const double top = 15.4;
  for (int side = 0; side < 4; ++side) {
    const Moved turned(builder, {0, 0, -half}, 0.25 * side);
    const Moved out(builder, {0, 0, half});
    const int lod = side == 0 || front_lod > 1 ? front_lod : front_lod + 1;
    if (side == 2) {
      panel(builder, -half, 0, half, top, 0, shaded(wall, 0.8));
      cornice(builder, -half - 0.4, half + 0.4, top, paints::pale_stone, lod, false);
      continue;
    }
    if (side == 0) {
      ground_floor(builder, 4.2, paints::limestone, paints::matt(0x6B2F2A), true, lod, 51);
    } else {
      rusticated(builder, -half, half, 0.5, 4.2, 7, paints::limestone, lod, 52);
      panel(builder, -half, 0, half, 0.5, 0.06, shaded(paints::limestone, 0.72));
    }
    Front front{.windows = {-1.45, 1.45}, .top = top, .wall = wall, .seed = 24U + static_cast<std::uint32_t>(side)};
    front.storeys = {{4.2, 3.8, 0.55, classical(2.35, WindowStyle::Head::pediment)},
                     {8.0, 3.6, 0.85, classical(2.0, WindowStyle::Head::lintel)},
                     {11.6, 3.4, 0.8, classical(1.75, WindowStyle::Head::lintel)}};
    front_wall(builder, front, lod);
    band(builder, -half, half, 4.1, 0.3, 0.16, paints::pale_stone, lod);
    if (lod < 3) band(builder, -half, half, 11.4, 0.2, 0.1, paints::pale_stone, lod);
    cornice(builder, -half - 0.4, half + 0.4, top, paints::pale_stone, lod, true);
  }
  const int lod = front_lod;
  const Moved middle(builder, {0, top + 0.7, -half});
  const double r = 1.41421356 * (half + 0.4);
  lathe(builder, {{r, 0}, {r * 0.82, 1.4}, {r * 0.62, 2.7}, {r * 0.34, 3.4}}, 4, paints::slate, Turned::faceted, 0.125);
  lathe(builder, {{r * 0.34, 3.4}, {0, 3.9}}, 4, shaded(paints::slate, 0.8), Turned::faceted, 0.125);
  if (lod < 2) {
    for (int side = 0; side < 4; ++side) {
      const Moved turned(builder, {0, 0, 0}, 0.25 * side);
      dormer(builder, {0, 0.25, half + 0.25}, 1.4, 1.6, 1.4, paints::pale_stone, paints::slate, lod, 60);
    }
    bar(builder, {0, 3.8, 0}, {0, 6.2, 0}, 0.07, 0.02, 5, paints::iron);
  }
  const Moved down(builder, {0, -top - 0.7, half});
  if (lod < 3) awning(builder, -2.3, 2.3, 3.55, 1.35, paints::matt(0xC08A2E), paints::matt(0xF4ECD8), 10, lod);
}

}  // namespace

std::vector<Prop> facade_props() {
  return {{"facade_a", facade_errors, facade_a},
          {"facade_b", facade_errors, facade_b},
          {"facade_c", facade_errors, facade_c_whole},
          {"facade_corner", facade_errors, facade_corner}};
}

}  // namespace throng::places
