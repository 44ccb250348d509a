#include "assets/places/shapes.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "assets/places/arithmetic.h"

namespace throng::places {

void box(MeshBuilder& builder, dvec3 low, dvec3 high, const Paint& paint, unsigned sides) {
  const auto corner = [&](int x, int y, int z) {
    return dvec3(x == 0 ? low.x : high.x, y == 0 ? low.y : high.y, z == 0 ? low.z : high.z);
  };
  const auto face = [&](unsigned bit, dvec3 a, dvec3 b, dvec3 c, dvec3 d) {
    if ((sides & bit) != 0) builder.quad(a, b, c, d, paint);
  };
  face(side::front, corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
  face(side::back, corner(1, 0, 0), corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0));
  face(side::left, corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
  face(side::right, corner(1, 0, 1), corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1));
  face(side::top, corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0), corner(0, 1, 0));
  face(side::bottom, corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
}

void panel(MeshBuilder& builder, double x0, double y0, double x1, double y1, double z, const Paint& paint) {
  builder.quad({x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}, paint);
}

void panel(MeshBuilder& builder, double x0, double y0, double x1, double y1, double z, const Paint& low,
           const Paint& high) {
  builder.add(
      {{Corner{{x0, y0, z}, low}, Corner{{x1, y0, z}, low}, Corner{{x1, y1, z}, high}, Corner{{x0, y1, z}, high}}, 4});
}

void moulding(MeshBuilder& builder, const std::vector<dvec2>& profile, double x0, double x1, const Paint& paint,
              bool ends) {
  const double wall = std::min(profile.front().x, profile.back().x);
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const dvec2 p = profile[i];
    const dvec2 q = profile[i + 1];
    builder.quad({x0, p.y, p.x}, {x1, p.y, p.x}, {x1, q.y, q.x}, {x0, q.y, q.x}, paint);
    if (!ends || p.y == q.y) continue;
    builder.quad({x0, p.y, wall}, {x0, p.y, p.x}, {x0, q.y, q.x}, {x0, q.y, wall}, paint);
    builder.quad({x1, q.y, wall}, {x1, q.y, q.x}, {x1, p.y, p.x}, {x1, p.y, wall}, paint);
  }
}

void lathe(MeshBuilder& builder, const std::vector<dvec2>& profile, int sides, const Paint& paint, Turned look,
           double from_turn) {
  const int whole = look == Turned::round ? builder.fresh_smooth() : 0;
  const auto at = [&](dvec2 p, int i) {
    const double turn = from_turn + static_cast<double>(i % sides) / sides;
    return dvec3(p.x * sine(turn), p.y, p.x * cosine(turn));
  };
  for (std::size_t p = 0; p + 1 < profile.size(); ++p) {
    const int group = look == Turned::edged ? builder.fresh_smooth() : whole;
    for (int i = 0; i < sides; ++i) {
      const dvec3 a = at(profile[p], i);
      const dvec3 b = at(profile[p], i + 1);
      const dvec3 c = at(profile[p + 1], i + 1);
      const dvec3 d = at(profile[p + 1], i);
      if (profile[p].x == 0) {
        builder.triangle(a, c, d, paint, group);
      } else if (profile[p + 1].x == 0) {
        builder.triangle(a, b, c, paint, group);
      } else {
        builder.quad(a, b, c, d, paint, group);
      }
    }
  }
}

void bar(MeshBuilder& builder, dvec3 from, dvec3 to, double from_radius, double to_radius, int sides,
         const Paint& paint, bool smooth) {
  const dvec3 along = glm::normalize(to - from);
  const dvec3 helper = along.y > 0.9 || along.y < -0.9 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
  const dvec3 u = glm::normalize(glm::cross(helper, along));
  const dvec3 v = glm::cross(along, u);
  const int group = smooth ? builder.fresh_smooth() : 0;
  const double half_turn = sides == 4 ? 0.125 : 0.0;
  for (int i = 0; i < sides; ++i) {
    const double t0 = half_turn + static_cast<double>(i) / sides;
    const double t1 = half_turn + static_cast<double>((i + 1) % sides) / sides;
    const dvec3 out0 = u * cosine(t0) + v * sine(t0);
    const dvec3 out1 = u * cosine(t1) + v * sine(t1);
    if (to_radius == 0) {
      builder.triangle(from + out0 * from_radius, from + out1 * from_radius, to, paint, group);
    } else {
      builder.quad(from + out0 * from_radius, from + out1 * from_radius, to + out1 * to_radius, to + out0 * to_radius,
                   paint, group);
    }
  }
}

void disc(MeshBuilder& builder, double radius, double y, int sides, const Paint& paint, double from_turn) {
  lathe(builder, {{radius, y}, {0, y}}, sides, paint, Turned::faceted, from_turn);
}

dvec2 Arch::point(int i) const {
  const double turn = 0.5 - 0.5 * static_cast<double>(i) / pieces;
  return {middle + half * cosine(turn), spring + rise * sine(turn)};
}

void wall_over_arch(MeshBuilder& builder, const Arch& arch, double top_y, double z, const Paint& paint) {
  for (int i = 0; i < arch.pieces; ++i) {
    const dvec2 p = arch.point(i);
    const dvec2 q = arch.point(i + 1);
    builder.quad({p.x, p.y, z}, {q.x, q.y, z}, {q.x, top_y, z}, {p.x, top_y, z}, paint);
  }
}

void arch_reveal(MeshBuilder& builder, const Arch& arch, double foot, double front_z, double back_z,
                 const Paint& paint) {
  const int group = builder.fresh_smooth();
  for (int i = 0; i < arch.pieces; ++i) {
    const dvec2 p = arch.point(i);
    const dvec2 q = arch.point(i + 1);
    builder.quad({p.x, p.y, back_z}, {q.x, q.y, back_z}, {q.x, q.y, front_z}, {p.x, p.y, front_z}, paint, group);
  }
  const double x0 = arch.middle - arch.half;
  const double x1 = arch.middle + arch.half;
  if (foot >= arch.spring) return;
  builder.quad({x0, foot, front_z}, {x0, foot, back_z}, {x0, arch.spring, back_z}, {x0, arch.spring, front_z}, paint);
  builder.quad({x1, foot, back_z}, {x1, foot, front_z}, {x1, arch.spring, front_z}, {x1, arch.spring, back_z}, paint);
}

void arch_ring(MeshBuilder& builder, const Arch& arch, double width, double z, double out, const Paint& paint,
               bool keystone) {
  Arch outer = arch;
  outer.half += width;
  outer.rise += width;
  const double face = z + out;
  for (int i = 0; i < arch.pieces; ++i) {
    const dvec2 p = arch.point(i);
    const dvec2 q = arch.point(i + 1);
    const dvec2 r = outer.point(i + 1);
    const dvec2 s = outer.point(i);
    const Paint stone = shaded(paint, i % 2 == 0 ? 1.0 : 0.9);
    builder.quad({p.x, p.y, face}, {q.x, q.y, face}, {r.x, r.y, face}, {s.x, s.y, face}, stone);
    if (out > 0) builder.quad({s.x, s.y, face}, {r.x, r.y, face}, {r.x, r.y, z}, {s.x, s.y, z}, stone);
    if (out > 0) builder.quad({p.x, p.y, z}, {q.x, q.y, z}, {q.x, q.y, face}, {p.x, p.y, face}, stone);
  }
  if (!keystone) return;
  const double crown = arch.spring + arch.rise;
  box(builder, {arch.middle - width * 0.4, crown - 0.05, z},
      {arch.middle + width * 0.4, crown + width * 1.25, face + 0.05}, paint, side::on_wall);
}

void arch_panel(MeshBuilder& builder, const Arch& arch, double z, const Paint& paint) {
  for (int i = 0; i < arch.pieces / 2; ++i) {
    const dvec2 a = arch.point(i);
    const dvec2 b = arch.point(arch.pieces - i);
    const dvec2 c = arch.point(arch.pieces - i - 1);
    const dvec2 d = arch.point(i + 1);
    if (c == d) {
      builder.triangle({a.x, a.y, z}, {b.x, b.y, z}, {c.x, c.y, z}, paint);
    } else {
      builder.quad({a.x, a.y, z}, {b.x, b.y, z}, {c.x, c.y, z}, {d.x, d.y, z}, paint);
    }
  }
}

}  // namespace throng::places
