#include "assets/mannequin/closest.h"

#include <glm/geometric.hpp>

namespace throng::mannequin {

using glm::dvec3;

// Ericson, Real-Time Collision Detection (2005), section 5.1.5.
std::array<double, 3> closest_on_triangle(dvec3 place, dvec3 a, dvec3 b, dvec3 c) {
  const dvec3 ab = b - a;
  const dvec3 ac = c - a;
  const double a1 = glm::dot(ab, place - a);
  const double a2 = glm::dot(ac, place - a);
  if (a1 <= 0 && a2 <= 0) return {1, 0, 0};
  const double b1 = glm::dot(ab, place - b);
  const double b2 = glm::dot(ac, place - b);
  if (b1 >= 0 && b2 <= b1) return {0, 1, 0};
  const double share_c = a1 * b2 - b1 * a2;
  if (share_c <= 0 && a1 >= 0 && b1 <= 0) return {1 - a1 / (a1 - b1), a1 / (a1 - b1), 0};
  const double c1 = glm::dot(ab, place - c);
  const double c2 = glm::dot(ac, place - c);
  if (c2 >= 0 && c1 <= c2) return {0, 0, 1};
  const double share_b = c1 * a2 - a1 * c2;
  if (share_b <= 0 && a2 >= 0 && c2 <= 0) return {1 - a2 / (a2 - c2), 0, a2 / (a2 - c2)};
  const double share_a = b1 * c2 - c1 * b2;
  if (share_a <= 0 && b2 >= b1 && c1 >= c2) {
    const double t = (b2 - b1) / ((b2 - b1) + (c1 - c2));
    return {0, 1 - t, t};
  }
  const double whole = share_a + share_b + share_c;
  return {share_a / whole, share_b / whole, share_c / whole};
}

ClosestPlace closest_place(dvec3 place, const Skin& skin, std::span<const std::array<std::size_t, 3>> triangles) {
  ClosestPlace closest{};
  double nearest = 1e9;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const dvec3 a = skin.points[triangles[t][0]].position;
    const dvec3 b = skin.points[triangles[t][1]].position;
    const dvec3 c = skin.points[triangles[t][2]].position;
    const auto shares = closest_on_triangle(place, a, b, c);
    const double distance = glm::distance(place, a * shares[0] + b * shares[1] + c * shares[2]);
    if (distance >= nearest) continue;
    nearest = distance;
    closest = {t, shares};
  }
  return closest;
}

}  // namespace throng::mannequin
