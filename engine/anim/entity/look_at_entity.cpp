#include "engine/anim/entity/look_at_entity.h"

#include <array>
#include <new>

#include "engine/anim/entity/whole_pose_step.h"

namespace throng::anim {
namespace {

void turn_all_to_targets(const PosedEntities& all) {
  // Constructed in place, since jobs that are initialised or copied first are written twice.
  alignas(LookAtJob) std::array<std::byte, widest_strip * sizeof(LookAtJob)> room;
  auto* const jobs = reinterpret_cast<LookAtJob*>(room.data());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const EntityInStore entity = all.entity(i);
    const auto& look = entity.as<LookAtEntity>();
    auto& memory = entity.private_as<LookAtMemory>();
    ::new (&jobs[i]) LookAtJob{.rig = &entity.resource_as<LookAtRig>(),
                               .state = &memory.gaze,
                               .pose = all.pose(i),
                               .target = {look.target[0], look.target[1], look.target[2]},
                               .seconds = entity.prepared_as<WholePoseStep>().seconds,
                               .limits = memory.limits,
                               .weight = value(look.weight)};
  }
  all.alike.assets->kernels->look_at({jobs, all.size()});
}

}  // namespace

EntityKind look_at_kind(const LookAtRig& rig) {
  return {.name = "look-at",
          .type = EntityType::look_at,
          .sources = only_source<LookAtEntity>,
          .private_bytes = sizeof(LookAtMemory),
          .prepared_bytes = whole_pose_prepared_bytes,
          .reads_identity = false,
          .advance = advance_each<advance_weighed<LookAtEntity>>,
          .pose_whole = pose_alone<turn_all_to_targets>,
          .whole_bones = rig.chain.bone_end(),
          .displaced_quads = 0,
          .pose_strip = turn_all_to_targets,
          .resource = &rig};
}

}  // namespace throng::anim
