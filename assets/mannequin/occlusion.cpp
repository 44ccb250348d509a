#include "assets/mannequin/occlusion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "assets/making/triangle.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;
using making::RayTriangle;

constexpr std::size_t ray_count = 64;
constexpr double reach = 0.25;  ///< Metres; further surface does not darken.
constexpr double clearance = 0.002;
constexpr double strength = 0.62;  ///< Of full occlusion.

/// Directions over the whole sphere on a Fibonacci spiral, even and free of chance.
std::array<dvec3, ray_count * 2> sphere_directions() {
  std::array<dvec3, ray_count * 2> directions;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double height = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(directions.size());
    const double angle = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0));
    const double radius = std::sqrt(1 - height * height);
    directions[i] = {radius * std::cos(angle), height, radius * std::sin(angle)};
  }
  return directions;
}

/// The triangles within reach that have a corner above the tangent plane.
std::vector<RayTriangle> gather(dvec3 origin, dvec3 normal, std::span<const dvec3> positions,
                                std::span<const std::array<std::size_t, 3>> triangles) {
  std::vector<RayTriangle> near;
  for (const auto& [a, b, c] : triangles) {
    const dvec3 offset = positions[a] - origin;
    if (glm::dot(offset, offset) > (reach + 0.1) * (reach + 0.1)) continue;
    const double height = std::max(
        {glm::dot(offset, normal), glm::dot(positions[b] - origin, normal), glm::dot(positions[c] - origin, normal)});
    if (height > 0) near.push_back({positions[a], positions[b] - positions[a], positions[c] - positions[a]});
  }
  return near;
}

}  // namespace

std::vector<double> bake_openness(std::span<const dvec3> positions, std::span<const dvec3> normals,
                                  std::span<const std::array<std::size_t, 3>> triangles) {
  static const auto directions = sphere_directions();
  std::vector<double> openness(positions.size(), 1.0);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (normals[v] == dvec3(0)) continue;
    const dvec3 origin = positions[v] + normals[v] * clearance;
    const std::vector<RayTriangle> near = gather(origin, normals[v], positions, triangles);
    double occluded = 0;
    double total = 0;
    for (const dvec3 direction : directions) {
      const double cosine = glm::dot(direction, normals[v]);
      if (cosine <= 0.05) continue;
      double distance = reach;
      for (const RayTriangle& triangle : near) distance = std::min(distance, hit(triangle, origin, direction, reach));
      occluded += cosine * (1 - distance / reach);
      total += cosine;
    }
    openness[v] = 1 - strength * occluded / total;
  }
  return openness;
}

}  // namespace throng::mannequin
