#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace throng::mannequin {

/// How open the surroundings of each vertex are: 1 in the open, less in folds and under the arms.
/// Vertices without a normal (used by no triangle) count as open.
std::vector<double> bake_openness(std::span<const glm::dvec3> positions, std::span<const glm::dvec3> normals,
                                  std::span<const std::array<std::size_t, 3>> triangles);

}  // namespace throng::mannequin
