#include "engine/anim/kernel/limb/look_at.h"

#include <string>

#include <glm/geometric.hpp>

#include "engine/anim/kernel/lanes/rotations.h"

namespace throng::anim {

namespace {

Error refused(const Skeleton& skeleton, const std::string& why) {
  return Error{"skeleton '" + skeleton.name + "' cannot look at things: " + why};
}

}  // namespace

Result<LookAtRig> make_look_at_rig(const Skeleton& skeleton, std::span<const LookBone> bones, const glm::vec3& forward,
                                   const glm::vec3& eyes_from_head) {
  if (bones.empty() || bones.size() > static_cast<std::size_t>(max_look_joints)) {
    return refused(skeleton,
                   "name 1 to " + std::to_string(max_look_joints) + " bones, not " + std::to_string(bones.size()));
  }
  Result<JointChain> chain = make_joint_chain(skeleton, bones.back().bone);
  if (!chain) return chain.error();
  const glm::vec3 level = unit_or({forward.x, 0.0F, forward.z}, glm::vec3(0.0F));
  if (glm::dot(level, level) < 0.5F) return refused(skeleton, "its forward direction points straight up or down");
  LookAtRig rig{.chain = *chain, .forward = level, .eyes = eyes_from_head};
  float sum = 0.0F;
  for (const LookBone& look : bones) {
    const auto i = static_cast<std::size_t>(rig.joint_count++);
    const int joint = chain->find(look.bone);
    if (joint < 0 || (i > 0 && joint <= rig.joints[i - 1])) {
      return refused(skeleton, "bone " + std::to_string(look.bone) + " is not between the bone before it and the head");
    }
    if (!(look.weight > 0.0F)) {
      return refused(skeleton, "bone " + std::to_string(look.bone) + " has no weight above 0: leave it out instead");
    }
    sum += look.weight;
    rig.joints[i] = static_cast<std::int16_t>(joint);
    rig.turned[i] = sum;
  }
  for (int i = 0; i < rig.joint_count; ++i) rig.turned[static_cast<std::size_t>(i)] /= sum;
  return rig;
}

}  // namespace throng::anim
