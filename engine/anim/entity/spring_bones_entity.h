#pragma once

#include <cstddef>
#include <span>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/entity/fading_weight.h"
#include "engine/anim/kernel/limb/spring_bones.h"

namespace throng::anim {

/// Lets hair and skirts of its source swing (kernel/limb/spring_bones.h).
///
///     [header 96 | spring bones 32 | transforms if resident | SpringBody 44 | a carrier 28, ... | a joint 36, ...]
struct alignas(64) SpringBonesEntity {
  static constexpr EntityType entity_type = EntityType::spring_bones;

  AnimationStateHeader state;  //   0
  Handle source;               //  96
  float reserved[3];           // 100
  FadingWeight weight;         // 112  0: the source's pose, to the bit
};
static_assert(sizeof(SpringBonesEntity) == entity_header_bytes);
static_assert(offsetof(SpringBonesEntity, source) == 96 && offsetof(SpringBonesEntity, weight) == 112);
static_assert(sizeof(SpringBody) == 44 && sizeof(JointMotion) == 28 && sizeof(SpringJointState) == 36);

/// The private part of a block. There are as many carriers as the rig has chains and colliders.
inline std::span<JointMotion> spring_carriers(const SpringRig& rig, SpringBody& body) {
  return {reinterpret_cast<JointMotion*>(&body + 1), rig.chains.size() + rig.colliders.size()};
}
inline std::span<SpringJointState> spring_joints(const SpringRig& rig, SpringBody& body) {
  const std::span<JointMotion> carriers = spring_carriers(rig, body);
  return {reinterpret_cast<SpringJointState*>(carriers.data() + carriers.size()), rig.joints.size()};
}

/// Returns the spring bones kind of a skeleton. The rig outlives it. A bone level that lacks one of its bones keeps the
/// source's pose.
EntityKind spring_bones_kind(const SpringRig& rig);

}  // namespace throng::anim
