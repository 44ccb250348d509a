#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "app/trajectory/trajectories.h"

namespace throng::app {

/// A rectangle on the ground: x and z in metres.
struct GroundBounds {
  glm::vec2 low{0.0F}, high{0.0F};
};

/// Returns what holds everybody at every time. There is at least one person.
GroundBounds bounds_of(const Trajectories& trajectories);

}  // namespace throng::app
