#include "engine/anim/entity/ik_entity.h"

#include "engine/anim/entity/whole_pose_step.h"

namespace throng::anim {
namespace {

std::size_t private_bytes(int, int) { return sizeof(IkMemory); }

void advance_ik(const EntityInStore& entity, const SourcesInStore& sources) {
  advance_weight(entity.as<IkEntity>().weight, begin_whole_pose(entity, sources).elapsed);
}

void reach(const EntityInStore& entity, const PoseView& pose) {
  const auto& ik = entity.as<IkEntity>();
  auto& memory = entity.private_as<IkMemory>();
  memory.missed_by = solve_two_bone_ik({.limb = &entity.resource_as<std::vector<TwoBoneLimb>>()[memory.limb],
                                        .pose = pose,
                                        .target = {ik.target[0], ik.target[1], ik.target[2]},
                                        .pole = memory.pole,
                                        .weight = value(ik.weight),
                                        .softness = memory.softness,
                                        .turn_end = memory.turn_end,
                                        .end_rotation = memory.end_rotation});
}

}  // namespace

EntityKind ik_kind(const std::vector<TwoBoneLimb>& limbs) {
  return {.name = "inverse kinematics",
          .type = EntityType::two_bone_ik,
          .sources = only_source<IkEntity>,
          .private_bytes = private_bytes,
          .prepared_bytes = whole_pose_prepared_bytes,
          .reads_identity = false,
          .advance = advance_each<advance_ik>,
          .pose_whole = reach,
          .whole_pose_work = 3,
          .resource = &limbs};
}

}  // namespace throng::anim
