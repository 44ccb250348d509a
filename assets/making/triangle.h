#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace throng::making {

/// Returns the point of a triangle that is nearest to `p`, as shares of its corners (Ericson, Real-Time Collision
/// Detection, 5.1.5).
inline glm::dvec3 nearest_shares(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

/// A triangle as rays meet it: a corner, and the edges from there to the others.
struct RayTriangle {
  glm::dvec3 corner, edge_a, edge_b;
};

/// Returns the distance to a triangle along a ray, or `reach` where that is less (Moeller and Trumbore 1997). Both
/// sides count.
inline double hit(const RayTriangle& triangle, glm::dvec3 origin, glm::dvec3 direction, double reach) {
  const glm::dvec3 p = glm::cross(direction, triangle.edge_b);
  const double determinant = glm::dot(triangle.edge_a, p);
  if (std::abs(determinant) < 1e-14) return reach;
  const glm::dvec3 offset = origin - triangle.corner;
  const double u = glm::dot(offset, p) / determinant;
  if (u < 0 || u > 1) return reach;
  const glm::dvec3 q = glm::cross(offset, triangle.edge_a);
  const double v = glm::dot(direction, q) / determinant;
  if (v < 0 || u + v > 1) return reach;
  const double distance = glm::dot(triangle.edge_b, q) / determinant;
  return distance > 0 ? std::min(distance, reach) : reach;
}

/// A triangle of a surface, with a ball around it.
struct BoundedTriangle {
  std::array<std::size_t, 3> corners;
  glm::dvec3 middle;
  double radius;
};
inline BoundedTriangle bounded(const std::array<std::size_t, 3>& corners, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const glm::dvec3 middle = (a + b + c) / 3.0;
  const double radius = std::max({glm::distance(a, middle), glm::distance(b, middle), glm::distance(c, middle)});
  return {corners, middle, radius};
}

/// A place on a surface, as shares of three of its points.
struct PlaceOnTriangle {
  std::array<std::size_t, 3> corners{};
  glm::dvec3 shares{0};
};

/// Returns the place nearest to `p` on the triangles that `may_use(triangle)` accepts; of equally near ones, the first.
/// `position(corner)` returns where a point of the surface is. Each triangle has a BoundedTriangle `bounds`.
template <typename Triangle, typename Position, typename MayUse>
PlaceOnTriangle nearest_place(glm::dvec3 p, std::span<const Triangle> triangles, const Position& position,
                              const MayUse& may_use) {
  constexpr double as_near = 1e-9;
  double nearest = std::numeric_limits<double>::infinity();
  PlaceOnTriangle best;
  for (const Triangle& triangle : triangles) {
    if (!may_use(triangle) || glm::distance(triangle.bounds.middle, p) - triangle.bounds.radius > nearest) continue;
    const auto& [a, b, c] = triangle.bounds.corners;
    const glm::dvec3 shares = nearest_shares(p, position(a), position(b), position(c));
    const glm::dvec3 there = shares.x * position(a) + shares.y * position(b) + shares.z * position(c);
    const double distance = glm::distance(there, p);
    if (distance >= nearest - as_near) continue;
    nearest = distance;
    best = {triangle.bounds.corners, shares};
  }
  return best;
}

}  // namespace throng::making
