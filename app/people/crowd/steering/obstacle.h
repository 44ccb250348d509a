#pragma once

#include <glm/vec2.hpp>

namespace throng::app {

/// A disc of ground on which no agent walks or stands.
struct Obstacle {
  glm::dvec2 position{0.0};  ///< x, z in metres
  double radius = 0.0;       ///< metres
};

}  // namespace throng::app
