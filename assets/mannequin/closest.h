#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <glm/vec3.hpp>

#include "assets/mannequin/mesh.h"

namespace throng::mannequin {

/// Where on a triangle a place is nearest: shares of its corners, which sum to one.
std::array<double, 3> closest_on_triangle(glm::dvec3 place, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c);

struct ClosestPlace {
  std::size_t triangle;
  std::array<double, 3> shares;
};
ClosestPlace closest_place(glm::dvec3 place, const Skin& skin, std::span<const std::array<std::size_t, 3>> triangles);

}  // namespace throng::mannequin
