#pragma once

#include <glm/vec2.hpp>

#include "engine/crowd/placed_agents.h"

namespace throng::app {

struct LanePoint {
  glm::dvec2 position{0.0};  ///< x, z in metres
  Heading heading;
};

/// A closed lane: a rectangle with round corners. All agents on it walk at one speed, so that none catches up.
/// Lanes of equal core whose corner radii differ by d run d apart all the way round.
struct Lane {
  glm::dvec2 centre{0.0};      ///< x, z in metres
  glm::dvec2 core{0.0};        ///< half extents of the rectangle of corner centres, metres; both 0 is a circle
  double corner_radius = 1.0;  ///< metres, above 0
  double direction = 1.0;      ///< 1 or -1
  double speed = 0.0;          ///< metres a second

  double length() const;
  /// Returns the place at `distance` metres from the lane's start in the direction of walking. Any distance wraps.
  LanePoint at(double distance) const;
  /// Returns the metres from `point` (x, z) to the lane: negative inside the loop, positive outside.
  double signed_distance(glm::dvec2 point) const;
};

}  // namespace throng::app
