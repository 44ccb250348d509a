#include "engine/anim/entity/spring_bones_entity.h"

#include "engine/anim/entity/whole_pose_step.h"

namespace throng::anim {
namespace {

void swing(const EntityInStore& entity, const PoseView& pose) {
  const auto& rig = entity.resource_as<SpringRig>();
  auto& body = entity.private_as<SpringBody>();
  swing_bones({.rig = &rig,
               .body = &body,
               .carriers = spring_carriers(rig, body),
               .joints = spring_joints(rig, body),
               .pose = pose,
               .seconds = entity.prepared_as<WholePoseStep>().seconds,
               .weight = value(entity.as<SpringBonesEntity>().weight)});
}

}  // namespace

EntityKind spring_bones_kind(const SpringRig& rig) {
  return {.name = "spring bones",
          .type = EntityType::spring_bones,
          .sources = only_source<SpringBonesEntity>,
          .private_bytes = sizeof(SpringBody) + (rig.chains.size() + rig.colliders.size()) * sizeof(JointMotion) +
                           rig.joints.size() * sizeof(SpringJointState),
          .prepared_bytes = whole_pose_prepared_bytes,
          .reads_identity = false,
          .advance = advance_each<advance_weighed<SpringBonesEntity>>,
          .pose_whole = swing,
          .whole_bones = rig.bone_end,
          .whole_pose_work = 1 + static_cast<int>(rig.nodes.size() + rig.joints.size()) / 4,
          .displaced_quads = 0,
          .resource = &rig};
}

}  // namespace throng::anim
