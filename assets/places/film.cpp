#include <glm/geometric.hpp>

#include "assets/places/arithmetic.h"
#include "assets/places/paints.h"
#include "assets/places/props.h"
#include "assets/places/shapes.h"

namespace throng::places {
namespace {

/// A spotlight on a tripod, 3 m high, that looks to +Z and a little down.
void stand(MeshBuilder& builder, int lod) {
  const Paint black = paints::metal(0x24262A);
  const int sides = lod == 0 ? 6 : 4;
  bar(builder, {0, 0.5, 0}, {0, 2.75, 0}, 0.03, 0.02, sides, paints::steel);
  for (int i = 0; i < 3; ++i) {
    const double t = i / 3.0 + 1.0 / 6;
    const dvec3 foot(0.75 * sine(t), 0.02, 0.75 * cosine(t));
    bar(builder, foot, {0, 1.3, 0}, 0.022, 0.022, sides, paints::steel);
    if (lod == 0) bar(builder, {foot.x * 0.55, 0.6, foot.z * 0.55}, {0, 0.6, 0}, 0.012, 0.012, 4, paints::steel);
  }
  const dvec3 back(0, 2.98, -0.28), front_at(0, 2.82, 0.3);
  const int ring = lod == 0 ? 12 : lod == 1 ? 8 : 5;
  bar(builder, back, front_at, 0.17, 0.24, ring, black);
  bar(builder, front_at, front_at + (front_at - back) * 0.02, 0.22, 0.001, ring,
      Paint{.color = rgb(0xFFF4D8), .glow = 255, .baked = false}, false);
  bar(builder, back, back - (front_at - back) * 0.12, 0.17, 0.0, ring, black);
  if (lod > 1) return;
  for (const double x : {-0.29, 0.29}) bar(builder, {x, 2.65, 0}, {x, 2.95, 0}, 0.02, 0.02, 4, black);
  bar(builder, {-0.29, 2.66, 0}, {0.29, 2.66, 0}, 0.02, 0.02, 4, black);
  if (lod > 0) return;
  for (const double y : {2.56, 3.06}) {
    const double out = y > 2.8 ? 0.25 : -0.25;
    builder.quad({-0.28, y, 0.36}, {0.28, y, 0.36}, {0.34, y + out, 0.5}, {-0.34, y + out, 0.5}, black);
    builder.quad({0.28, y, 0.36}, {-0.28, y, 0.36}, {-0.34, y + out, 0.5}, {0.34, y + out, 0.5}, black);
  }
}

/// A camera on the arm of a crane on a dolly; the arm reaches to +Z, 5 m high.
void camera_crane(MeshBuilder& builder, int lod) {
  const Paint black = paints::metal(0x25272B);
  const Paint grey = paints::metal(0x8B9094);
  const int sides = lod == 0 ? 8 : lod == 1 ? 5 : 4;
  box(builder, {-0.7, 0.25, -1.0}, {0.7, 0.42, 1.0}, black, side::all_sides);
  for (const double x : {-0.7, 0.7}) {
    for (const double z : {-0.8, 0.8})
      bar(builder, {x - 0.07, 0.2, z}, {x + 0.07, 0.2, z}, 0.2, 0.2, sides, paints::matt(0x1C1C1E));
    for (const double z : {-0.8, 0.8})
      bar(builder, {x + 0.07, 0.2, z}, {x + 0.08, 0.2, z}, 0.2, 0.0, sides, grey, false);
    for (const double z : {-0.8, 0.8})
      bar(builder, {x - 0.07, 0.2, z}, {x - 0.08, 0.2, z}, 0.2, 0.0, sides, grey, false);
  }
  lathe(builder, {{0.4, 0.42}, {0.25, 0.6}, {0.16, 0.7}, {0.14, 1.9}}, sides, grey);
  const dvec3 pivot(0, 2.0, 0), tail(0, 0.9, -2.0), nose(0, 4.7, 5.0);
  for (const double x : {-0.12, 0.12}) {
    for (const double y : {-0.1, 0.14})
      bar(builder, tail + dvec3(x, y, 0), nose + dvec3(x * 0.5, y * 0.5, 0), 0.03, 0.025, 4, grey, false);
  }
  const int rungs = lod == 0 ? 18 : lod == 1 ? 7 : 0;
  for (int i = 0; i < rungs; ++i) {
    const double t0 = static_cast<double>(i) / rungs, t1 = static_cast<double>(i + 1) / rungs;
    const dvec3 a = tail + (nose - tail) * t0, b = tail + (nose - tail) * t1;
    for (const double x : {-0.12, 0.12})
      bar(builder, a + dvec3(x, -0.1, 0), b + dvec3(x * 0.9, 0.12, 0), 0.014, 0.014, 3, grey, false);
  }
  box(builder, {-0.28, 0.55, -2.35}, {0.28, 1.15, -1.85}, shaded(black, 1.4), side::all_sides);
  bar(builder, pivot + dvec3(-0.2, 0, 0), pivot + dvec3(0.2, 0, 0), 0.09, 0.09, sides, black);
  const Moved head(builder, nose);
  bar(builder, {0, 0.05, 0}, {0, -0.35, 0.1}, 0.05, 0.05, sides, black);
  box(builder, {-0.14, -0.72, -0.2}, {0.14, -0.35, 0.32}, black, side::all_sides);
  bar(builder, {0, -0.55, 0.32}, {0, -0.58, 0.58}, 0.09, 0.11, sides, black);
  bar(builder, {0, -0.58, 0.58}, {0, -0.58, 0.585}, 0.1, 0.0, sides, paints::glass(0), false);
  if (lod > 1) return;
  lathe(builder, {{0.0, -0.36}, {0.14, -0.3}, {0.14, -0.22}, {0.0, -0.18}}, sides, black);
}

}  // namespace

std::vector<Prop> film_props() {
  return {{"stand", {0, 0.02, 0.06}, stand, 0.4}, {"camera_crane", {0, 0.03, 0.1}, camera_crane, 0.6}};
}

}  // namespace throng::places
