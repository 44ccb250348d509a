#include "assets/places/arithmetic.h"
#include "assets/places/house.h"
#include "assets/places/paints.h"
#include "assets/places/props.h"

namespace throng::places {
namespace {

constexpr double tower_half = 3.2;

void clock_face(MeshBuilder& builder, double y, int lod) {
  constexpr double radius = 1.35;
  const int sides = lod == 0 ? 16 : lod == 1 ? 12 : 8;
  const Paint face{.color = rgb(0xF4EEDC), .glow = 160};
  for (int i = 0; i < sides; ++i) {
    const double t0 = static_cast<double>(i) / sides, t1 = static_cast<double>(i + 1) / sides;
    const dvec3 a(radius * cosine(t0), y + radius * sine(t0), 0.1), b(radius * cosine(t1), y + radius * sine(t1), 0.1);
    const dvec3 rim_a = a + dvec3(0.22 * cosine(t0), 0.22 * sine(t0), 0.08),
                rim_b = b + dvec3(0.22 * cosine(t1), 0.22 * sine(t1), 0.08);
    builder.triangle({0, y, 0.1}, a, b, face);
    builder.quad(a, rim_a, rim_b, b, paints::metal(0x8A6A32));
    builder.quad(rim_a, {rim_a.x, rim_a.y, 0}, {rim_b.x, rim_b.y, 0}, rim_b, paints::limestone);
  }
  if (lod > 0) return;
  const Paint hand = paints::matt(0x1E1E20);
  for (int i = 0; i < 12; ++i) {
    const double t = i / 12.0;
    const dvec3 way(sine(t), cosine(t), 0), across(cosine(t) * 0.04, -sine(t) * 0.04, 0);
    const dvec3 c(0, y, 0.12);
    builder.quad(c + way * 1.05 - across, c + way * 1.05 + across, c + way * 1.26 + across, c + way * 1.26 - across,
                 hand);
  }
  const auto pointer = [&](double t, double length, double width) {
    const dvec3 way(sine(t), cosine(t), 0), across(cosine(t) * width, -sine(t) * width, 0), c(0, y, 0.14);
    builder.quad(c - way * 0.2 - across, c - way * 0.2 + across, c + way * length + across * 0.4,
                 c + way * length - across * 0.4, hand);
  };
  pointer(0.35, 0.75, 0.07);
  pointer(0.18, 1.1, 0.05);
}

void tower_side(MeshBuilder& builder, int lod, int side) {
  constexpr double h = tower_half;
  const Paint stone = paints::limestone;
  const Paint wall = paints::matt(0xC98F6B);
  panel(builder, -h, 0, h, 4.5, 0, stone);
  panel(builder, -h, 4.5, h, 23.0, -0.1, wall);
  panel(builder, -h, 23.0, h, 27.2, 0, stone);
  for (const double x : {-h, h - 0.9}) {
    rusticated(builder, x, x + 0.9, 4.5, 23.0, 9, stone, lod, 200);
  }
  band(builder, -h - 0.1, h + 0.1, 4.3, 0.5, 0.25, paints::pale_stone, lod);
  band(builder, -h - 0.1, h + 0.1, 22.8, 0.5, 0.3, paints::pale_stone, lod);
  const WindowStyle slit{.head = WindowStyle::Head::round,
                         .width = 0.8,
                         .height = 2.0,
                         .trim = paints::pale_stone,
                         .frame = paints::matt(0x40342A)};
  for (const double y : {7.0, 12.2, 17.4})
    window(builder, 0, y, slit, lod < 2 ? 2 : 3, static_cast<std::uint32_t>(side) + static_cast<std::uint32_t>(y));
  clock_face(builder, 25.15, lod);
  cornice(builder, -h - 0.3, h + 0.3, 27.2, paints::pale_stone, lod, true);
  if (side == 0 && lod < 2) {
    const Arch door{0, 1.1, 2.2, 1.1, 8};
    arch_ring(builder, door, 0.35, 0, 0.12, paints::pale_stone, true);
    panel(builder, -1.1, 0, 1.1, 2.2, 0.04, paints::matt(0x4B3222));
    arch_panel(builder, door, 0.04, paints::matt(0x4B3222));
    for (const double x : {-1.45, 1.1})
      box(builder, {x, 0, 0}, {x + 0.35, 2.2, 0.12}, paints::pale_stone, side::on_wall);
  }
}

void belfry_side(MeshBuilder& builder, int lod) {
  constexpr double h = 2.7;
  const Paint stone = paints::pale_stone;
  const Moved moved(builder, {0, 0, h});
  if (lod >= 2) {
    panel(builder, -h, 28, h, 34, 0, stone);
    for (const double x : {-1.15, 1.15}) panel(builder, x - 0.65, 28.8, x + 0.65, 32.6, 0.04, paints::matt(0x33302B));
  } else {
    for (const double x : {-1.2, 1.2}) {
      const Arch arch{x, 0.75, 31.4, 0.75, lod == 0 ? 6 : 4};
      wall_over_arch(builder, arch, 34, 0, stone);
      arch_reveal(builder, arch, 28.6, 0, -0.5, shaded(stone, 0.9));
      panel(builder, x - 0.75, 28, x + 0.75, 28.6, 0, stone);
      for (int i = 0; i < (lod == 0 ? 5 : 3); ++i) {
        const double step = lod == 0 ? 0.63 : 1.05;
        const double y = 28.7 + step * i;
        builder.quad({x - 0.75, y, -0.2}, {x + 0.75, y, -0.2}, {x + 0.75, y + step * 0.6, -0.5},
                     {x - 0.75, y + step * 0.6, -0.5}, paints::matt(0x5A4A3A));
      }
      panel(builder, x - 0.75, 28.6, x + 0.75, 32.2, -0.52, paints::matt(0x1A1714));
    }
    panel(builder, -h, 28, -1.95, 34, 0, stone);
    panel(builder, -0.45, 28, 0.45, 34, 0, stone);
    panel(builder, 1.95, 28, h, 34, 0, stone);
  }
  cornice(builder, -h - 0.35, h + 0.35, 33.6, paints::limestone, lod, false);
}

/// A clock tower with a belfry, 43 m to the tip of its vane.
void tower(MeshBuilder& builder, int lod) {
  for (int side = 0; side < 4; ++side) {
    {
      const Moved turned(builder, {0, 0, -tower_half}, 0.25 * side);
      const Moved out(builder, {0, 0, tower_half});
      tower_side(builder, lod, side);
    }
    const Moved turned(builder, {0, 0, -tower_half}, 0.25 * side);
    belfry_side(builder, lod);
  }
  const Moved middle(builder, {0, 0, -tower_half});
  box(builder, {-3.6, 27.9, -3.6}, {3.6, 28, 3.6}, paints::granite, side::top);
  if (lod < 2) {
    for (int i = 0; i < 4; ++i) {
      const Moved turned(builder, {0, 0, 0}, 0.25 * i);
      for (int j = 0; j < 6; ++j)
        box(builder, {-3.3 + 1.2 * j - 0.1, 27.9, 3.3}, {-3.1 + 1.2 * j + 0.1, 28.7, 3.5}, paints::limestone,
            lod == 0 ? side::front | side::back | side::left | side::right : unsigned{side::front});
      box(builder, {-3.5, 28.7, 3.25}, {3.5, 28.9, 3.55}, paints::limestone, side::all_sides);
    }
  }
  const double r = 1.41421356 * 3.0;
  lathe(builder, {{r, 34.2}, {r * 0.6, 36.0}, {r * 0.42, 38.0}, {0, 42.0}}, 4, paints::copper, Turned::faceted, 0.125);
  if (lod < 2) {
    lathe(builder, {{0.12, 41.5}, {0.32, 42.0}, {0.12, 42.4}, {0.03, 42.5}, {0.03, 44.0}, {0, 44.1}}, 6,
          paints::metal(0xB8923F));
  }
}

}  // namespace

std::vector<Prop> tower_props() { return {{"tower", {0, 0.05, 0.2}, tower, 2.5}}; }

}  // namespace throng::places
