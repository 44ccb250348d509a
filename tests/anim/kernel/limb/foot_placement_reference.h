#pragma once

#include "engine/anim/kernel/limb/foot_placement.h"

namespace throng::anim {

/// Does what foot_placement.h says for one character, without vectors and posing anew what it changed. The kernels are
/// held to it. Returns how far the pelvis was lowered.
float place_feet_by_definition(const FootPlacementJob& job);

/// Returns the way from the ankle to the ground below the joint of the toes, which stay flat on ground of this normal.
glm::vec3 under_toes(const PlacedLeg& leg, const glm::quat& foot, const glm::vec3& normal);

}  // namespace throng::anim
