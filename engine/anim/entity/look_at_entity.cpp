#include "engine/anim/entity/look_at_entity.h"

#include "engine/anim/entity/whole_pose_step.h"

namespace throng::anim {
namespace {

std::size_t private_bytes(int, int) { return sizeof(LookAtMemory); }

void advance_look(const EntityInStore& entity, std::span<const AnimationStateHeader* const> states) {
  advance_weight(entity.as<LookAtEntity>().weight, begin_whole_pose(entity, states).elapsed);
}

void turn_to_target(const EntityInStore& entity, const PoseView& pose) {
  const auto& look = entity.as<LookAtEntity>();
  auto& memory = entity.private_as<LookAtMemory>();
  memory.remaining = look_at({.rig = &entity.resource_as<LookAtRig>(),
                              .state = &memory.gaze,
                              .pose = pose,
                              .target = {look.target[0], look.target[1], look.target[2]},
                              .seconds = entity.prepared_as<WholePoseStep>().seconds,
                              .weight = value(look.weight),
                              .limits = memory.limits});
}

}  // namespace

EntityKind look_at_kind(const LookAtRig& rig) {
  return {.name = "look-at",
          .type = EntityType::look_at,
          .sources = only_source<LookAtEntity>,
          .private_bytes = private_bytes,
          .prepared_bytes = whole_pose_prepared_bytes,
          .advance = advance_look,
          .pose_whole = turn_to_target,
          .resource = &rig};
}

}  // namespace throng::anim
