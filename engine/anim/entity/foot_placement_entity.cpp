#include "engine/anim/entity/foot_placement_entity.h"

#include <array>
#include <new>

#include "engine/anim/entity/whole_pose_step.h"

namespace throng::anim {
namespace {

void place_all(const PosedEntities& all) {
  // Constructed in place, since jobs that are initialised or copied first are written twice.
  alignas(FootPlacementJob) std::array<std::byte, widest_strip * sizeof(FootPlacementJob)> room;
  auto* const jobs = reinterpret_cast<FootPlacementJob*>(room.data());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const EntityInStore entity = all.entity(i);
    auto& memory = entity.private_as<FootPlacementMemory>();
    ::new (&jobs[i]) FootPlacementJob{.rig = &entity.resource_as<FootPlacementRig>(),
                                      .body = &memory.body,
                                      .feet = memory.feet,
                                      .pose = all.pose(i),
                                      .seconds = entity.prepared_as<WholePoseStep>().seconds,
                                      .weight = value(entity.as<FootPlacementEntity>().weight)};
  }
  all.alike.assets->kernels->place_feet({jobs, all.size()});
  for (std::size_t i = 0; i < all.size(); ++i) {
    all.entity(i).as<FootPlacementEntity>().drop = jobs[i].body->drop.value * jobs[i].weight;
  }
}

}  // namespace

EntityKind foot_placement_kind(const FootPlacementRig& rig) {
  return {.name = "foot placement",
          .type = EntityType::foot_placement,
          .sources = only_source<FootPlacementEntity>,
          .private_bytes = sizeof(PlacedBody) + static_cast<std::size_t>(rig.leg_count) * sizeof(PlacedFoot),
          .prepared_bytes = whole_pose_prepared_bytes,
          .reads_identity = false,
          .advance = advance_each<advance_weighed<FootPlacementEntity>>,
          .pose_whole = pose_alone<place_all>,
          .whole_bones = rig.bone_end,
          .whole_pose_work = foot_placement_work,
          .displaced_quads = quads_with(rig.pelvis_bone()),
          .pose_strip = place_all,
          .resource = &rig};
}

}  // namespace throng::anim
