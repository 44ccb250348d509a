#include <array>

#include "assets/places/arithmetic.h"
#include "assets/places/house.h"
#include "assets/places/paints.h"
#include "assets/places/props.h"

namespace throng::places {
namespace {

constexpr int kiosk_sides = 8;
constexpr double kiosk_radius = 1.35;

/// One of eight sides, its middle at z = 0.
void kiosk_side(MeshBuilder& builder, int lod, bool open, std::uint32_t seed) {
  const double half = kiosk_radius * 0.41421356;
  const Paint wood = paints::matt(0x2F5547);
  const Paint panel_paint = shaded(wood, 1.35);
  panel(builder, -half, 0, half, 1.0, 0, wood);
  panel(builder, -half, 2.35, half, 2.7, 0, wood);
  for (const double x : {-half, half - 0.08})
    box(builder, {x, 0, -0.05}, {x + 0.08, 2.7, 0.04}, shaded(wood, 0.85), side::front | side::left | side::right);
  if (open) {
    panel(builder, -half, 1.0, half, 2.35, -0.9, Paint{.color = rgb(0x8A6B45), .glow = 200});
    builder.quad({-half, 1.0, 0}, {half, 1.0, 0}, {half, 1.0, -0.9}, {-half, 1.0, -0.9}, paints::timber);
    if (lod < 2) box(builder, {-half - 0.05, 0.98, 0}, {half + 0.05, 1.04, 0.28}, paints::timber, side::on_wall);
    if (lod == 0) {
      for (int i = 0; i < 7; ++i) {
        const double x = -half + 0.1 + i * (2 * half - 0.2) / 7;
        constexpr std::array<std::uint32_t, 5> goods{0xC94A3A, 0xE6C34A, 0x3E7CB1, 0xF0EDE4, 0x5A9A5A};
        const double h = 0.14 + 0.2 * chance(seed, static_cast<std::uint32_t>(i));
        box(builder, {x, 1.0, -0.2}, {x + 0.11, 1.0 + h, -0.05}, paints::matt(goods[static_cast<std::size_t>(i) % 5]));
        box(builder, {x, 1.55, -0.85}, {x + 0.11, 1.55 + 0.7 * h + 0.1, -0.75},
            paints::matt(goods[static_cast<std::size_t>(i + 2) % 5]),
            side::front | side::top | side::left | side::right);
      }
      box(builder, {-half, 1.5, -0.9}, {half, 1.54, -0.7}, paints::timber, side::front | side::top | side::bottom);
    }
    return;
  }
  panel(builder, -half, 1.0, half, 2.35, 0, paints::glass(150));
  if (lod > 1) return;
  panel(builder, -half + 0.14, 0.12, half - 0.14, 0.88, 0.015, panel_paint);
  if (lod > 0) return;
  for (int i = 0; i < 4; ++i) {
    constexpr std::array<std::uint32_t, 4> covers{0xD95F4A, 0x4A7FB5, 0xEADBB0, 0x6FA36A};
    const double x = -half + 0.13 + 0.44 * (i % 2);
    const double y = 1.15 + (i < 2 ? 0.0 : 0.58);
    panel(builder, x, y, x + 0.36, y + 0.48, 0.02, paints::matt(covers[static_cast<std::size_t>(i)]));
  }
}

/// A newspaper kiosk of eight sides under a striped roof.
void kiosk(MeshBuilder& builder, int lod) {
  const double inner = kiosk_radius;
  for (int i = 0; i < kiosk_sides; ++i) {
    const Moved turned(builder, {0, 0, 0}, i / 8.0);
    const Moved out(builder, {0, 0, inner});
    const bool open = i == 0 || i == 1 || i == 7;
    kiosk_side(builder, lod, open, static_cast<std::uint32_t>(i));
  }
  const double corner = kiosk_radius / 0.92387953;
  const Paint stripes[2] = {paints::matt(0xC2453A), paints::matt(0xF3EAD6)};
  const int sectors = lod == 0 ? 24 : lod == 1 ? 16 : 8;
  const double eaves = corner + 0.75;
  const auto at = [&](double r, double y, int i) {
    const double t = 1.0 / 16 + static_cast<double>(i % sectors) / sectors;
    return dvec3(r * sine(t), y, r * cosine(t));
  };
  for (int i = 0; i < sectors; ++i) {
    const Paint& paint = stripes[i % 2];
    builder.quad(at(eaves, 2.62, i), at(eaves, 2.62, i + 1), at(corner * 0.62, 3.12, i + 1), at(corner * 0.62, 3.12, i),
                 paint);
    builder.triangle(at(corner * 0.62, 3.12, i), at(corner * 0.62, 3.12, i + 1), {0, 3.75, 0}, paint);
    if (lod > 1) continue;
    builder.quad(at(eaves, 2.4, i), at(eaves, 2.4, i + 1), at(eaves, 2.62, i + 1), at(eaves, 2.62, i),
                 shaded(paint, 0.92));
    builder.quad(at(eaves - 0.03, 2.4, i + 1), at(eaves - 0.03, 2.4, i), at(eaves - 0.03, 2.62, i),
                 at(eaves - 0.03, 2.62, i + 1), shaded(paint, 0.8));
    builder.quad(at(eaves, 2.6, i + 1), at(eaves, 2.6, i), at(corner, 2.7, i), at(corner, 2.7, i + 1),
                 shaded(paint, 0.75));
  }
  if (lod < 2)
    lathe(builder, {{0.1, 3.62}, {0.17, 3.8}, {0.08, 3.95}, {0.02, 4.05}, {0, 4.3}}, 8, paints::metal(0xB8923F));
}

}  // namespace

std::vector<Prop> kiosk_props() { return {{"kiosk", {0, 0.04, 0.2}, kiosk, 0.8}}; }

}  // namespace throng::places
