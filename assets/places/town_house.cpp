#include "assets/places/arithmetic.h"
#include "assets/places/house.h"
#include "assets/places/paints.h"
#include "assets/places/props.h"

namespace throng::places {
namespace {

constexpr double town_bay = 3.0;  ///< half a bay's width
constexpr double town_depth = 8.0;
const std::vector<double> town_errors{0, 0.035, 0.1, 0.3};
const Paint zinc = paints::matt(0x7C8894);

/// A balcony over the whole bay at a floor's height.
void long_balcony(MeshBuilder& builder, double floor, int lod) {
  constexpr double out = 0.75;
  const Paint& stone = paints::pale_stone;
  if (lod < 3) {
    box(builder, {-town_bay, floor - 0.2, 0}, {town_bay, floor - 0.02, out}, stone,
        side::front | side::top | side::bottom);
  }
  if (lod >= 2) return;
  const Paint& iron = paints::iron;
  const double z = out - 0.06;
  panel(builder, -town_bay, floor + 0.9, town_bay, floor + 0.97, z, iron);
  panel(builder, -town_bay, floor + 0.1, town_bay, floor + 0.14, z, iron);
  const int bars = lod == 0 ? 26 : 10;
  const double wide = lod == 0 ? 0.025 : 0.04;
  for (int i = 0; i < bars; ++i) {
    const double x = -town_bay + 2 * town_bay * (i + 0.5) / bars;
    panel(builder, x - wide / 2, floor, x + wide / 2, floor + 0.9, z, iron);
  }
  if (lod > 0) return;
  for (int i = 0; i < 4; ++i) {
    const double x = -town_bay + 2 * town_bay * (i + 0.5) / 4;
    box(builder, {x - 0.1, floor - 0.62, 0}, {x + 0.1, floor - 0.2, 0.4}, stone,
        side::front | side::left | side::right);
  }
}

WindowStyle french_window(double height) {
  return {.head = WindowStyle::Head::plain,
          .width = 1.0,
          .height = height,
          .rows = 3,
          .trim = paints::pale_stone,
          .frame = paints::white_paint,
          .surround = false};
}

/// Five storeys of pale stone below a roof of zinc, with balconies from end to end.
void facade_d(MeshBuilder& builder, int lod) {
  const Paint wall = paints::tinted(0xE8DDC6);
  ground_floor(builder, 4.3, paints::limestone, paints::matt(0x3B2330), false, lod, 61);
  constexpr double eaves = 17.2;
  Front front{.windows = {-1.95, 0, 1.95}, .top = eaves, .wall = wall, .seed = 25};
  front.storeys = {{4.3, 3.0, 0.5, french_window(2.1)},
                   {7.4, 3.4, 0.1, french_window(2.6)},
                   {10.9, 3.2, 0.5, french_window(2.2)},
                   {14.1, 3.1, 0.1, french_window(2.3)}};
  front_wall(builder, front, lod);
  if (lod < 3) band(builder, -town_bay, town_bay, 4.2, 0.3, 0.16, paints::pale_stone, lod);
  long_balcony(builder, 7.4, lod);
  long_balcony(builder, 14.1, lod);
  cornice(builder, -town_bay, town_bay, eaves, paints::pale_stone, lod, false);
  const Paint side_wall = shaded(wall, 0.85);
  closed_box(builder, 6, 0, eaves + 0.65, town_depth, side_wall, shaded(wall, 0.8));
  mansard_roof(
      builder,
      {.front_z = 0.1, .back_z = -town_depth, .eaves = eaves + 0.65, .ridge = eaves + 3.6, .tile = zinc, .seed = 9},
      lod, side_wall);
  for (const double x : {-1.95, 0.0, 1.95}) {
    dormer(builder, {x, eaves + 0.8, -0.05}, 1.1, 1.45, 1.2, paints::pale_stone, zinc, lod, x > 0 ? 72U : 70U);
  }
  chimney(builder, {2.4, eaves + 3.0, -3.0}, 2.0, side_wall, lod);
  if (lod < 3) awning(builder, -2.3, 2.3, 3.6, 1.3, paints::matt(0x8A2F3E), paints::matt(0xEEDFC8), 8, lod);
}

/// The box of an oriel in the middle of a front, from `foot` to `top`.
void oriel(MeshBuilder& builder, double foot, double top, const Paint& wall, int lod) {
  constexpr double half = 1.2;
  constexpr double out = 0.85;
  const Paint& trim = paints::pale_stone;
  {
    const Moved moved(builder, {0, 0, out});
    WindowStyle style{.head = WindowStyle::Head::plain,
                      .width = 1.7,
                      .height = 1.9,
                      .columns = 3,
                      .rows = 2,
                      .trim = trim,
                      .frame = paints::white_paint,
                      .surround = false,
                      .flowers = lod < 2};
    Front front{.width = 2 * half, .windows = {0}, .top = top, .wall = wall, .seed = 28};
    front.storeys = {{foot, 3.1, 0.75, style}, {foot + 3.1, 3.1, 0.75, style}};
    front_wall(builder, front, lod);
  }
  box(builder, {-half, foot, 0}, {half, top, out}, wall, side::left | side::right);
  if (lod < 2) {
    for (const double y : {foot + 0.75, foot + 3.85}) {
      const Paint glass = paints::glass(y < 6 ? 190 : 0);
      box(builder, {-half - 0.01, y, 0.2}, {half + 0.01, y + 1.9, 0.7}, glass, side::left | side::right);
    }
  }
  // A corbel below, and a roof of copper above.
  const auto corner = [&](double x, double y, double z) { return dvec3(x, y, z); };
  const double low = foot - 0.9;
  const Paint stone = shaded(trim, 0.9);
  builder.quad(corner(-0.5, low, 0), corner(0.5, low, 0), corner(half, foot, out), corner(-half, foot, out), stone);
  builder.triangle(corner(0.5, low, 0), corner(half, foot, 0), corner(half, foot, out), stone);
  builder.triangle(corner(-0.5, low, 0), corner(-half, foot, out), corner(-half, foot, 0), stone);
  const double peak = top + 1.3;
  const double e = 0.15;
  builder.quad(corner(-half - e, top, out + e), corner(half + e, top, out + e), corner(0.5, peak, 0),
               corner(-0.5, peak, 0), paints::copper);
  builder.triangle(corner(half + e, top, out + e), corner(half + e, top, 0), corner(0.5, peak, 0), paints::copper);
  builder.triangle(corner(-half - e, top, 0), corner(-half - e, top, out + e), corner(-0.5, peak, 0), paints::copper);
  if (lod < 2) box(builder, {-half - e, top - 0.14, 0}, {half + e, top, out + e}, trim, side::on_wall & ~side::top);
}

/// A plastered house with an oriel and a gable over it.
void facade_e(MeshBuilder& builder, int lod) {
  const Paint wall = paints::tinted(0xE4C2A0);
  ground_floor(builder, 4.0, paints::dark_stone, paints::matt(0x3F5560), true, lod, 66);
  constexpr double eaves = 13.4;
  const WindowStyle slim{.head = WindowStyle::Head::lintel,
                         .width = 0.85,
                         .height = 1.7,
                         .rows = 2,
                         .trim = paints::pale_stone,
                         .frame = paints::white_paint};
  Front front{.windows = {-2.1, 2.1}, .top = eaves, .wall = wall, .seed = 26};
  front.storeys = {{4.4, 3.1, 0.95, slim}, {7.5, 3.1, 0.95, slim}, {10.6, 2.8, 0.75, slim}};
  front.storeys[0].foot = 4.0;
  front.storeys[0].sill = 1.35;
  front_wall(builder, front, lod);
  band(builder, -town_bay, town_bay, 3.9, 0.25, 0.14, paints::pale_stone, lod);
  oriel(builder, 4.9, 11.1, wall, lod);
  const Paint side_wall = shaded(wall, 0.85);
  closed_box(builder, 6, 0, eaves, town_depth, side_wall, shaded(wall, 0.8));
  gable_roof(builder,
             {.front_z = 0.55,
              .back_z = -town_depth,
              .eaves = eaves - 0.1,
              .ridge = eaves + 3.6,
              .tile = shaded(paints::roof_tile, 0.85),
              .seed = 18},
             lod, side_wall);
  dormer(builder, {0, eaves - 0.4, 0.06}, 2.4, 2.2, 2.6, wall, shaded(paints::roof_tile, 0.8), lod, 75);
  chimney(builder, {-2.2, eaves + 2.2, -2.6}, 1.9, paints::brick, lod);
  if (lod < 3) awning(builder, -2.3, 2.3, 3.3, 1.25, paints::matt(0xD9B45A), paints::matt(0xF4ECD8), 10, lod);
}

}  // namespace

std::vector<Prop> town_house_props() {
  return {{"facade_d", town_errors, facade_d}, {"facade_e", town_errors, facade_e}};
}

}  // namespace throng::places
