#pragma once

#include "throng/math.h"

#include "engine/anim/kernel/limb/joint_chain.h"
#include "engine/base/glm_numbers.h"

namespace throng::anim {

inline JointMotion to_joint(const Place& place) {
  return {.rotation = to_glm(place.rotation), .position = to_glm(place.position)};
}
inline Place from_joint(const JointMotion& joint) {
  return {.position = from_glm(joint.position), .rotation = from_glm(joint.rotation)};
}

}  // namespace throng::anim
