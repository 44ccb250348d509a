#include "assets/places/window.h"

#include "assets/places/arithmetic.h"
#include "assets/places/paints.h"

namespace throng::places {
namespace {

constexpr double of_round_head = 0.22;  ///< rise of a segmental arch, by its width

/// One opening in a wall at z = 0.
struct Opening {
  double x0, x1, y0, y1;
};

int light_of(std::uint32_t seed) {
  const double dice = chance(seed, 7);
  return dice < 0.42 ? static_cast<int>(90 + dice / 0.42 * 165) : 0;
}

Arch head_of(const Opening& at, const WindowStyle& style) {
  const double rise = style.width * of_round_head;
  return {0.5 * (at.x0 + at.x1), 0.5 * style.width, at.y1 - rise, rise, 4};
}

void panes(MeshBuilder& builder, const Opening& at, const WindowStyle& style, int lod, std::uint32_t seed) {
  constexpr double bar = 0.05;
  const double z = -style.reveal;
  panel(builder, at.x0, at.y0, at.x1, at.y1, z, style.frame);
  const int columns = lod == 0 ? style.columns : 2;
  const int rows = lod == 0 ? style.rows : 2;
  const Paint glass = paints::glass(light_of(seed));
  const double w = (at.x1 - at.x0 - bar) / columns;
  const double h = (at.y1 - at.y0 - bar) / rows;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double x = at.x0 + bar + i * w;
      const double y = at.y0 + bar + j * h;
      const auto pane = static_cast<std::uint32_t>(i * 8 + j);
      const Paint pane_glass = shaded(glass, 0.85 + 0.3 * chance(seed, pane + 20));
      const double low = 0.45 + 0.55 * j / rows;
      panel(builder, x, y, x + w - bar, y + h - bar, z + 0.02, paints::dimmed(pane_glass, low),
            paints::dimmed(pane_glass, low + 0.55 / rows));
    }
  }
}

void reveal(MeshBuilder& builder, const Opening& at, const WindowStyle& style, const Paint& paint) {
  const double z = -style.reveal;
  if (style.head == WindowStyle::Head::round) {
    arch_reveal(builder, head_of(at, style), at.y0, 0, z, paint);
  } else {
    builder.quad({at.x0, at.y0, 0}, {at.x0, at.y0, z}, {at.x0, at.y1, z}, {at.x0, at.y1, 0}, paint);
    builder.quad({at.x1, at.y0, z}, {at.x1, at.y0, 0}, {at.x1, at.y1, 0}, {at.x1, at.y1, z}, paint);
    builder.quad({at.x0, at.y1, z}, {at.x1, at.y1, z}, {at.x1, at.y1, 0}, {at.x0, at.y1, 0}, paint);
  }
}

void surround(MeshBuilder& builder, const Opening& at, const WindowStyle& style) {
  constexpr double width = 0.14;
  constexpr double out = 0.05;
  const Paint& trim = style.trim;
  if (style.head == WindowStyle::Head::round) {
    arch_ring(builder, head_of(at, style), width + 0.06, 0, out, trim, true);
    return;
  }
  if (style.surround) {
    box(builder, {at.x0 - width, at.y0, 0}, {at.x0, at.y1, out}, trim, side::front | side::left);
    box(builder, {at.x1, at.y0, 0}, {at.x1 + width, at.y1, out}, trim, side::front | side::right);
  }
  box(builder, {at.x0 - width, at.y1, 0}, {at.x1 + width, at.y1 + 0.2, out}, trim,
      side::front | side::left | side::right);
  const double y = at.y1 + 0.2;
  const double x0 = at.x0 - width - 0.08;
  const double x1 = at.x1 + width + 0.08;
  box(builder, {x0, y, 0}, {x1, y + 0.07, 0.16}, trim, side::front | side::top | side::bottom);
  if (style.head != WindowStyle::Head::pediment) return;
  const double middle = 0.5 * (x0 + x1);
  const dvec3 peak(middle, y + 0.42, 0.12);
  builder.triangle({x0, y + 0.07, 0.12}, {x1, y + 0.07, 0.12}, peak, trim);
  builder.quad({x0, y + 0.07, 0.16}, {middle, y + 0.44, 0.16}, {middle, y + 0.44, 0}, {x0, y + 0.07, 0}, trim);
  builder.quad({middle, y + 0.44, 0.16}, {x1, y + 0.07, 0.16}, {x1, y + 0.07, 0}, {middle, y + 0.44, 0}, trim);
}

/// The same from afar.
void flat_surround(MeshBuilder& builder, const Opening& at, const WindowStyle& style) {
  constexpr double width = 0.14;
  constexpr double z = 0.04;
  if (style.surround && style.head != WindowStyle::Head::round) {
    panel(builder, at.x0 - width, at.y0, at.x0, at.y1, z, style.trim);
    panel(builder, at.x1, at.y0, at.x1 + width, at.y1, z, style.trim);
  }
  const double x0 = at.x0 - width;
  const double x1 = at.x1 + width;
  if (style.head == WindowStyle::Head::round) {
    arch_ring(builder, head_of(at, style), width + 0.06, z, 0, style.trim, false);
    return;
  }
  panel(builder, x0, at.y1, x1, at.y1 + 0.2, z, style.trim);
  box(builder, {x0 - 0.08, at.y1 + 0.2, 0}, {x1 + 0.08, at.y1 + 0.27, 0.14}, style.trim, side::front | side::bottom);
  if (style.head != WindowStyle::Head::pediment) return;
  builder.triangle({x0 - 0.08, at.y1 + 0.27, 0.13}, {x1 + 0.08, at.y1 + 0.27, 0.13},
                   {0.5 * (x0 + x1), at.y1 + 0.64, 0.13}, style.trim);
}

void shutters(MeshBuilder& builder, const Opening& at, const WindowStyle& style, int lod) {
  const double leaf = 0.5 * style.width;
  for (const double x : {at.x0 - leaf - 0.02, at.x1 + 0.02}) {
    box(builder, {x, at.y0 + 0.02, 0.01}, {x + leaf, at.y1, 0.06}, style.shutter,
        lod == 0 ? side::front | side::left | side::right : side::front);
    if (lod > 0) continue;
    for (const double y : {0.08, 0.54}) {
      const double from = at.y0 + style.height * y;
      panel(builder, x + 0.08, from, x + leaf - 0.08, from + style.height * 0.38, 0.065, shaded(style.shutter, 0.78));
    }
  }
}

void railing(MeshBuilder& builder, const Opening& at, const WindowStyle& style, int lod) {
  const double x0 = at.x0 - 0.3;
  const double x1 = at.x1 + 0.3;
  box(builder, {x0 - 0.05, at.y0 - 0.16, 0}, {x1 + 0.05, at.y0, 0.62}, style.trim, side::on_wall);
  const Paint& iron = paints::iron;
  if (lod > 0) {
    panel(builder, x0, at.y0 + 0.9, x1, at.y0 + 0.98, 0.59, iron);
    for (int i = 0; i < 5; ++i) {
      const double x = x0 + (x1 - x0 - 0.04) * i / 4;
      panel(builder, x, at.y0, x + 0.04, at.y0 + 0.9, 0.59, iron);
    }
    return;
  }
  for (const double x : {x0 + 0.15, x1 - 0.15}) {
    box(builder, {x - 0.07, at.y0 - 0.46, 0}, {x + 0.07, at.y0 - 0.16, 0.3}, style.trim,
        side::front | side::left | side::right);
  }
  box(builder, {x0, at.y0 + 0.93, 0.54}, {x1, at.y0 + 0.98, 0.59}, iron, side::front | side::top);
  box(builder, {x0, at.y0 + 0.08, 0.55}, {x1, at.y0 + 0.11, 0.58}, iron, side::front | side::top);
  const int bars = static_cast<int>((x1 - x0) / 0.19);
  for (int i = 0; i <= bars; ++i) {
    const double x = x0 + (x1 - x0 - 0.024) * i / bars;
    panel(builder, x, at.y0, x + 0.024, at.y0 + 0.95, 0.57, iron);
  }
  for (const double x : {x0, x1}) {
    box(builder, {x, at.y0 + 0.93, 0}, {x, at.y0 + 0.98, 0.56}, iron, side::right);
    for (const double z : {0.18, 0.38}) box(builder, {x, at.y0, z}, {x, at.y0 + 0.95, z + 0.03}, iron, side::right);
  }
}

void flowers(MeshBuilder& builder, const Opening& at, int lod, std::uint32_t seed) {
  const Paint pot = paints::matt(0x9C5A3C);
  box(builder, {at.x0 + 0.05, at.y0 + 0.02, 0.02}, {at.x1 - 0.05, at.y0 + 0.18, 0.2}, pot,
      side::front | side::left | side::right);
  const int count = lod == 0 ? 8 : 3;
  for (int i = 0; i < count; ++i) {
    const auto n = static_cast<std::uint32_t>(i);
    const double x = at.x0 + 0.1 + (at.x1 - at.x0 - 0.2) * (i + 0.5) / count;
    const double size = (lod == 0 ? 0.09 : 0.2) + 0.05 * chance(seed, n);
    const double y = at.y0 + 0.16 + 0.1 * chance(seed, n + 30);
    const double z = 0.1 + 0.12 * chance(seed, n + 60);
    const Paint leaf = i % 3 == 1   ? paints::matt(0xC8443A)
                       : i % 3 == 0 ? paints::matt(0x5B7F3B)
                                    : paints::matt(0x7A9A4A);
    builder.quad({x - size, y, z}, {x, y - size * 0.6, z + 0.05}, {x + size, y, z}, {x, y + size, z - 0.02}, leaf);
  }
}

}  // namespace

void window(MeshBuilder& builder, double x, double y, const WindowStyle& style, int lod, std::uint32_t seed) {
  const Opening at{x - style.width / 2, x + style.width / 2, y, y + style.height};
  if (!window_is_hole(lod)) {
    if (style.shutters && lod == 2) {
      panel(builder, at.x0 - style.width * 0.5, at.y0, at.x1 + style.width * 0.5, at.y1, 0.03, style.shutter);
    } else if (lod == 2) {
      panel(builder, at.x0 - 0.12, at.y0 - 0.1, at.x1 + 0.12, at.y1 + 0.2, 0.03, style.trim);
    }
    panel(builder, at.x0, at.y0, at.x1, at.y1, lod == 2 ? 0.06 : 0.04, shaded(paints::glass(light_of(seed)), 0.9));
    return;
  }
  panes(builder, at, style, lod, seed);
  reveal(builder, at, style, shaded(style.trim, 0.95));
  if (lod == 0) surround(builder, at, style);
  if (lod == 1) flat_surround(builder, at, style);
  const unsigned sill_sides = lod == 0 ? side::front | side::top | side::bottom : side::front | side::bottom;
  box(builder, {at.x0 - 0.12, at.y0 - 0.11, 0}, {at.x1 + 0.12, at.y0, 0.12}, style.trim, sill_sides);
  if (style.shutters) shutters(builder, at, style, lod);
  if (style.railing) railing(builder, at, style, lod);
  if (style.flowers) flowers(builder, at, lod, seed);
}

}  // namespace throng::places
