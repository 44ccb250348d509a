#include "engine/anim/entity/ik_entity.h"

#include <array>
#include <bit>

#include "engine/anim/entity/whole_pose_step.h"

namespace throng::anim {
namespace {

TwoBoneIkJob job_of(const EntityInStore& entity, const PoseView& pose) {
  const auto& ik = entity.as<IkEntity>();
  const auto& memory = entity.private_as<IkMemory>();
  return {.limb = &entity.resource_as<std::vector<TwoBoneLimb>>()[memory.limb],
          .pose = pose,
          .target = {ik.target[0], ik.target[1], ik.target[2]},
          .pole = memory.pole,
          .weight = value(ik.weight),
          .softness = memory.softness,
          .turn_end = memory.turn_end,
          .end_rotation = memory.end_rotation};
}

/// Solves the characters that reach with the same limb in one call.
void reach_all(const PosedEntities& all) {
  std::array<TwoBoneIkJob, widest_strip> jobs;
  std::array<std::size_t, widest_strip> reaching;
  std::array<float, widest_strip> missed_by;
  const auto limb_of = [&](std::size_t i) -> std::uint32_t { return all.entity(i).private_as<IkMemory>().limb; };
  for (std::uint32_t left = (1U << all.size()) - 1U; left != 0;) {
    const std::uint32_t limb = limb_of(static_cast<std::size_t>(std::countr_zero(left)));
    std::size_t count = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if ((left >> i & 1U) == 0 || limb_of(i) != limb) continue;
      left &= ~(1U << i);
      reaching[count] = i;
      jobs[count++] = job_of(all.entity(i), all.pose(i));
    }
    all.alike.assets->kernels->two_bone_ik(std::span(jobs).first(count), missed_by.data());
    for (std::size_t k = 0; k < count; ++k) {
      all.entity(reaching[k]).private_as<IkMemory>().missed_by = missed_by[k];
    }
  }
}

}  // namespace

EntityKind ik_kind(const std::vector<TwoBoneLimb>& limbs) {
  return {.name = "inverse kinematics",
          .type = EntityType::two_bone_ik,
          .sources = only_source<IkEntity>,
          .private_bytes = sizeof(IkMemory),
          .prepared_bytes = whole_pose_prepared_bytes,
          .reads_identity = false,
          .advance = advance_each<advance_weighed<IkEntity>>,
          .pose_whole = pose_alone<reach_all>,
          .whole_bones = bone_end_of(limbs),
          .displaced_quads = 0,
          .pose_strip = reach_all,
          .resource = &limbs};
}

}  // namespace throng::anim
