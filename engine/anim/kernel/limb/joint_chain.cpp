#include "engine/anim/kernel/limb/joint_chain.h"

#include <cassert>
#include <string>

namespace throng::anim {

int JointChain::find(int bone) const {
  const auto end = bones.begin() + count;
  const auto found = std::find(bones.begin(), end, bone);
  return found == end ? -1 : static_cast<int>(found - bones.begin());
}

Result<JointChain> make_joint_chain(const Skeleton& skeleton, int bone) {
  if (bone < 0 || bone >= skeleton.bone_count()) {
    return Error{"skeleton '" + skeleton.name + "' has no bone " + std::to_string(bone) + ": name one of its " +
                 std::to_string(skeleton.bone_count()) + " bones"};
  }
  const std::string& name = skeleton.bones[static_cast<std::size_t>(bone)].name;
  if (!skeleton.rigid) {
    return Error{"skeleton '" + skeleton.name + "' scales or shears its bones, so the chain to bone '" + name +
                 "' cannot be solved: export it without scale on bones"};
  }
  JointChain chain;
  for (int b = bone; b >= 0; b = skeleton.bones[static_cast<std::size_t>(b)].parent) {
    if (chain.count == JointChain::max_joints) {
      return Error{"bone '" + name + "' of skeleton '" + skeleton.name + "' is more than " +
                   std::to_string(JointChain::max_joints) + " joints below its root: choose a bone nearer to it"};
    }
    chain.bones[static_cast<std::size_t>(chain.count++)] = static_cast<std::int16_t>(b);
  }
  std::reverse(chain.bones.begin(), chain.bones.begin() + chain.count);
  glm::dvec3 parent_origin(0.0);
  for (int joint = 0; joint < chain.count; ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    const glm::dvec3 origin = skeleton.references[static_cast<std::size_t>(chain.bones[j])].origin;
    chain.offsets[j] = glm::vec3(origin - parent_origin);
    parent_origin = origin;
  }
  return chain;
}

namespace {

void pose_joint(const JointChain& chain, std::size_t joint, const PoseView& pose, std::span<JointMotion> motions) {
  const JointMotion parent = joint == 0 ? JointMotion{} : motions[joint - 1];
  const int bone = chain.bones[joint];
  motions[joint] = {.rotation = renormalised(parent.rotation * pose.rotation(bone)),
                    .position = parent.position + parent.rotation * (chain.offsets[joint] + pose.position(bone))};
}

}  // namespace

void pose_chain(const JointChain& chain, const PoseView& pose, std::span<JointMotion> motions, int first) {
  assert(is_within(chain, pose) && pose.components == rigid_components);
  assert(motions.size() >= static_cast<std::size_t>(chain.count));
  for (int joint = first; joint < chain.count; ++joint) {
    pose_joint(chain, static_cast<std::size_t>(joint), pose, motions);
  }
}

}  // namespace throng::anim
