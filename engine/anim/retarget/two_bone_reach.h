#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace throng::anim {

/// Three joints of a leg, model space.
struct LegPlaces {
  glm::dvec3 hip{0.0};
  glm::dvec3 knee{0.0};
  glm::dvec3 ankle{0.0};
};

/// Holds the turns of both bones of a leg, in model space.
struct LegTurns {
  glm::dquat upper{1.0, 0.0, 0.0, 0.0};
  glm::dquat lower{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 ankle{0.0};  ///< where the leg then ends: the target, or as near to it as the leg reaches
};

/// Bends a leg until it ends at `target`. The knee keeps its side; where the leg is straight, it bends towards
/// `forward`. It bends by at most 160 degrees. A leg without length stays as it is.
LegTurns reach(const LegPlaces& leg, const glm::dvec3& target, const glm::dvec3& forward);

/// Returns how far the hip has to come down for the leg to reach `target`, metres; 0 where it reaches or where no drop
/// would do.
double drop_to_reach(const LegPlaces& leg, const glm::dvec3& target);

}  // namespace throng::anim
