#include <algorithm>

#include "assets/places/arithmetic.h"
#include "assets/places/house.h"
#include "assets/places/paints.h"

namespace throng::places {

void awning(MeshBuilder& builder, double x0, double x1, double y, double out, const Paint& one, const Paint& other,
            int stripes, int lod) {
  const int count = lod == 0 ? stripes : lod == 1 ? std::max(3, stripes / 2) : 1;
  Paint mixed = one;
  mixed.color = (one.color + other.color) * 0.5;
  const double drop = out * 0.42;
  const double edge = y - drop;
  for (int i = 0; i < count; ++i) {
    const Paint& paint = count == 1 ? mixed : i % 2 == 0 ? one : other;
    const double a = x0 + (x1 - x0) * i / count;
    const double b = x0 + (x1 - x0) * (i + 1) / count;
    const double sag = edge + drop * 0.56;
    builder.quad({a, sag, out * 0.5}, {b, sag, out * 0.5}, {b, y, 0.02}, {a, y, 0.02}, paint);
    builder.quad({a, edge, out}, {b, edge, out}, {b, sag, out * 0.5}, {a, sag, out * 0.5}, paint);
    builder.quad({a, edge - 0.22, out}, {b, edge - 0.22, out}, {b, edge, out}, {a, edge, out}, shaded(paint, 0.9));
  }
  if (lod < 2)
    builder.quad({x0, y - 0.02, 0.02}, {x1, y - 0.02, 0.02}, {x1, edge, out - 0.02}, {x0, edge, out - 0.02},
                 shaded(mixed, 0.6));
  for (const double x : {x0, x1}) {
    builder.triangle({x, y, 0.02}, {x, edge, 0.02}, {x, edge, out}, shaded(one, 0.85));
  }
}

void shop_front(MeshBuilder& builder, double x0, double x1, double foot, double height, double reveal,
                const Paint& wood, bool door_left, int lod, std::uint32_t seed) {
  const double z = -reveal;
  const double top_y = foot + height;
  if (lod >= 2) {
    panel(builder, x0, foot, x1, top_y, 0.04, wood);
    panel(builder, x0 + 0.3, foot + 0.5, x1 - 0.3, top_y - 0.7, 0.07, paints::shop_glass);
    return;
  }
  builder.quad({x0, foot, 0}, {x0, foot, z}, {x0, top_y, z}, {x0, top_y, 0}, wood);
  builder.quad({x1, foot, z}, {x1, foot, 0}, {x1, top_y, 0}, {x1, top_y, z}, wood);
  builder.quad({x0, top_y, z}, {x1, top_y, z}, {x1, top_y, 0}, {x0, top_y, 0}, wood);
  panel(builder, x0, foot, x1, top_y, z, wood);
  const double door = 1.05;
  const double door_x = door_left ? x0 + 0.14 : x1 - 0.14 - door;
  const double glass_x0 = door_left ? door_x + door + 0.16 : x0 + 0.14;
  const double glass_x1 = door_left ? x1 - 0.14 : door_x - 0.16;
  const Paint lit = paints::shop_glass;
  panel(builder, door_x + 0.12, foot + 0.75, door_x + door - 0.12, foot + 2.15, z + 0.02, paints::dimmed(lit, 0.25),
        lit);
  panel(builder, door_x, foot + 2.3, door_x + door, top_y - 0.55, z + 0.02, shaded(lit, 0.9));
  if (lod == 0) {
    panel(builder, door_x + 0.12, foot + 0.14, door_x + door - 0.12, foot + 0.65, z + 0.02, shaded(wood, 0.75));
    box(builder, {door_x + door - 0.13, foot + 1.0, z + 0.02}, {door_x + door - 0.07, foot + 1.2, z + 0.08},
        paints::metal(0xB08A3C), side::on_wall);
    box(builder, {glass_x0 - 0.04, foot, z}, {glass_x1 + 0.04, foot + 0.55, z + 0.1}, shaded(wood, 0.9),
        side::front | side::left | side::right | side::top);
  }
  const int panes = lod == 0 ? 3 : 1;
  for (int i = 0; i < panes; ++i) {
    const double a = glass_x0 + (glass_x1 - glass_x0) * i / panes;
    const double b = glass_x0 + (glass_x1 - glass_x0) * (i + 1) / panes - 0.06;
    panel(builder, a, foot + 0.62, b, foot + 2.2, z + 0.02, paints::dimmed(lit, 0.25), shaded(lit, 0.9 + 0.05 * i));
    panel(builder, a, foot + 2.3, b, top_y - 0.55, z + 0.02, shaded(lit, 0.95));
  }
  // The board with the shop's name.
  box(builder, {x0 - 0.05, top_y - 0.45, z}, {x1 + 0.05, top_y + 0.05, 0.1}, shaded(wood, 1.15), side::on_wall);
  if (lod > 0) return;
  const double middle = 0.5 * (x0 + x1);
  const int letters = 6 + static_cast<int>(3 * chance(seed, 5));
  for (int i = 0; i < letters; ++i) {
    const double x = middle + (i - letters / 2.0) * 0.26;
    const double h = 0.16 + 0.07 * chance(seed, static_cast<std::uint32_t>(i) + 90);
    panel(builder, x, top_y - 0.32, x + 0.15, top_y - 0.32 + h, 0.115, paints::matt(0xE9D9A8));
  }
}

void ground_floor(MeshBuilder& builder, double height, const Paint& stone, const Paint& wood, bool door_left, int lod,
                  std::uint32_t seed) {
  constexpr double pier = 0.62;
  constexpr double bay = 3.0;
  const double top = height - 0.55;
  if (lod == 3) {
    panel(builder, -bay, 0, bay, height, 0.02, stone);
    shop_front(builder, -bay + pier, bay - pier, 0, top, 0.45, wood, door_left, lod, seed);
    return;
  }
  const Paint plinth = shaded(stone, 0.72);
  for (const double x : {-bay, bay - pier}) {
    rusticated(builder, x, x + pier, 0.5, top, 6, stone, lod, seed + static_cast<std::uint32_t>(x + 9));
    if (lod < 2) {
      moulding(builder, {{0, 0}, {0.09, 0}, {0.09, 0.44}, {0.02, 0.5}}, x, x + pier, plinth);
    } else {
      panel(builder, x, 0, x + pier, 0.5, 0.03, plinth);
    }
  }
  panel(builder, -bay, top, bay, height, 0.02, stone);
  shop_front(builder, -bay + pier, bay - pier, 0, top, 0.45, wood, door_left, lod, seed);
}

}  // namespace throng::places
