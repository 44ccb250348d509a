#pragma once

#include <cstddef>
#include <span>

#include "engine/anim/kernel/limb/joint_chain.h"

namespace throng::anim {

/// Returns the rotation of a joint's parent in model space, the identity for the root.
inline glm::quat parent_rotation(std::span<const JointMotion> motions, int joint) {
  return joint == 0 ? JointMotion{}.rotation : motions[static_cast<std::size_t>(joint) - 1].rotation;
}

}  // namespace throng::anim
