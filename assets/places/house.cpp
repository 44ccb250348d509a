#include "assets/places/house.h"

#include <algorithm>

#include "assets/places/arithmetic.h"
#include "assets/places/paints.h"

namespace throng::places {
namespace {

/// The lines at which a front's wall is cut, so that no corner lies on another's edge.
std::vector<double> wall_columns(const Front& front) {
  const double half = front.width / 2;
  const double reach = front.storeys.front().window.width / 2;
  std::vector<double> xs{-half};
  for (const double x : front.windows) {
    xs.push_back(x - reach);
    xs.push_back(x + reach);
  }
  xs.push_back(half);
  return xs;
}

std::vector<double> wall_rows(const Front& front) {
  std::vector<double> ys{front.storeys.front().foot};
  for (const Storey& storey : front.storeys) {
    ys.push_back(storey.foot + storey.sill);
    ys.push_back(storey.foot + storey.sill + storey.window.height);
  }
  ys.push_back(front.top);
  return ys;
}

void wall_with_holes(MeshBuilder& builder, const Front& front) {
  const std::vector<double> xs = wall_columns(front);
  const std::vector<double> ys = wall_rows(front);
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
      if (i % 2 == 1 && j % 2 == 1) continue;
      panel(builder, xs[i], ys[j], xs[i + 1], ys[j + 1], 0, front.wall);
    }
  }
}

/// Where windows have round heads, the wall comes down to the arch.
void wall_corners(MeshBuilder& builder, const Front& front) {
  for (const Storey& storey : front.storeys) {
    if (storey.window.head != WindowStyle::Head::round) continue;
    const double rise = storey.window.width * 0.22;
    const double head = storey.foot + storey.sill + storey.window.height;
    for (const double x : front.windows) {
      wall_over_arch(builder, {x, storey.window.width / 2, head - rise, rise, 4}, head, 0, front.wall);
    }
  }
}

}  // namespace

void front_wall(MeshBuilder& builder, const Front& front, int lod) {
  const double half = front.width / 2;
  if (window_is_hole(lod)) {
    wall_with_holes(builder, front);
    wall_corners(builder, front);
  } else {
    panel(builder, -half, front.storeys.front().foot, half, front.top, 0, front.wall);
  }
  std::uint32_t number = front.seed * 64;
  for (const Storey& storey : front.storeys) {
    for (const double x : front.windows) window(builder, x, storey.foot + storey.sill, storey.window, lod, ++number);
  }
}

void band(MeshBuilder& builder, double x0, double x1, double y, double height, double out, const Paint& paint,
          int lod) {
  if (lod >= 2) {
    panel(builder, x0, y, x1, y + height, 0.07, paint);
  } else if (lod == 1) {
    moulding(builder, {{0, y}, {out, y + height * 0.5}, {out, y + height * 0.9}}, x0, x1, paint);
  } else {
    moulding(
        builder,
        {{0, y}, {out * 0.5, y + height * 0.45}, {out, y + height * 0.6}, {out, y + height * 0.85}, {0, y + height}},
        x0, x1, paint);
  }
}

double cornice(MeshBuilder& builder, double x0, double x1, double y, const Paint& paint, int lod, bool brackets) {
  constexpr double out = 0.55;
  if (lod >= 2) {
    moulding(builder, {{0, y}, {out, y + 0.35}, {out, y + 0.7}, {0, y + 0.7}}, x0, x1, paint, lod == 2);
    return out;
  }
  std::vector<dvec2> profile{{0.06, y},        {0.08, y + 0.28}, {0.3, y + 0.42}, {0.45, y + 0.42},
                             {0.45, y + 0.55}, {out, y + 0.66},  {out, y + 0.7},  {0, y + 0.74}};
  if (lod == 1) profile = {{0, y}, {0.08, y + 0.28}, {0.45, y + 0.42}, {out, y + 0.68}, {0, y + 0.74}};
  moulding(builder, profile, x0, x1, paint, true);
  if (!brackets || lod > 0) return out;
  constexpr int count = 7;
  for (int i = 0; i < count; ++i) {
    const double x = x0 + (x1 - x0) * (i + 0.5) / count;
    box(builder, {x - 0.09, y + 0.16, 0.08}, {x + 0.09, y + 0.42, 0.4}, paint,
        side::front | side::left | side::right | side::bottom);
  }
  return out;
}

void closed_box(MeshBuilder& builder, double width, double foot, double top, double depth, const Paint& side,
                const Paint& back_wall) {
  const double half = width / 2;
  box(builder, {-half, foot, -depth}, {half, top, 0}, side, side::left | side::right);
  box(builder, {-half, foot, -depth}, {half, top, 0}, back_wall, side::back);
}

void rusticated(MeshBuilder& builder, double x0, double x1, double y0, double y1, int courses, const Paint& paint,
                int lod, std::uint32_t seed) {
  if (lod >= 1) {
    panel(builder, x0, y0, x1, y1, 0.02, paint);
    return;
  }
  const double height = (y1 - y0) / courses;
  constexpr double joint = 0.035;
  for (int i = 0; i < courses; ++i) {
    const double y = y0 + i * height;
    const Paint stone = shaded(paint, 0.9 + 0.16 * chance(seed, static_cast<std::uint32_t>(i)));
    moulding(builder, {{0, y}, {0.05, y + joint}, {0.05, y + height}}, x0, x1, stone);
  }
}

}  // namespace throng::places
