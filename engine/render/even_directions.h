#pragma once

#include <cmath>

#include <glm/vec3.hpp>

namespace throng::render {

/// Points that follow each other at this angle, in radians, never gather: of a circle it is the smaller part of the
/// golden section.
inline constexpr float golden_angle = 2.39996323F;

/// Returns direction `index` of `count` that are spread evenly over the sphere, from the top to the bottom.
inline glm::vec3 even_direction(int index, int count) {
  const float rise = 1.0F - 2.0F * (static_cast<float>(index) + 0.5F) / static_cast<float>(count);
  const float flat = std::sqrt(1.0F - rise * rise), turn = golden_angle * static_cast<float>(index);
  return {flat * std::cos(turn), rise, flat * std::sin(turn)};
}

}  // namespace throng::render
