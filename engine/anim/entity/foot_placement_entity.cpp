#include "engine/anim/entity/foot_placement_entity.h"

#include <algorithm>

#include "engine/anim/entity/whole_pose_step.h"

namespace throng::anim {
namespace {

std::size_t private_bytes(int, int) { return sizeof(FootPlacementMemory); }

void advance_feet(const EntityInStore& entity, const SourcesInStore& sources) {
  advance_weight(entity.as<FootPlacementEntity>().weight, begin_whole_pose(entity, sources).elapsed);
}

GroundContact contact_under(const glm::vec3& ankle, const Footing& ground, const JointMotion& model_in_world) {
  const glm::quat back = glm::conjugate(model_in_world.rotation);
  const Footing local{.place = back * (ground.place - model_in_world.position), .normal = back * ground.normal};
  const bool has_height = local.normal.y > 0.0F;
  return {.height = has_height ? ground_height(local, ankle.x, ankle.z) : local.place.y, .normal = local.normal};
}

void place(const EntityInStore& entity, const PoseView& pose) {
  const auto& rig = entity.resource_as<FootPlacementRig>();
  auto& placement = entity.as<FootPlacementEntity>();
  auto& memory = entity.private_as<FootPlacementMemory>();
  PosedLegs legs;
  if (!pose_legs(rig, pose, legs)) {
    memory.feet = {};
    return;
  }
  GroundContact contacts[max_legs];
  for (std::size_t leg = 0; leg < static_cast<std::size_t>(rig.leg_count); ++leg) {
    memory.ankles[leg] = ankle_of(rig, legs, leg);
    contacts[leg] = contact_under(memory.ankles[leg], memory.ground[leg], memory.model_in_world);
  }
  const FootPlacementJob job{.rig = &rig,
                             .state = &memory.feet,
                             .pose = pose,
                             .contacts = contacts,
                             .planted = memory.planted,
                             .model_in_world = memory.model_in_world,
                             .seconds = entity.prepared_as<WholePoseStep>().seconds,
                             .weight = value(placement.weight),
                             .options = memory.options};
  const FootPlacementResult placed = place_feet(job, legs);
  placement.drop = placed.drop;
  std::ranges::copy(placed.missed_by, memory.missed_by);
}

}  // namespace

EntityKind foot_placement_kind(const FootPlacementRig& rig) {
  return {.name = "foot placement",
          .type = EntityType::foot_placement,
          .sources = only_source<FootPlacementEntity>,
          .private_bytes = private_bytes,
          .prepared_bytes = whole_pose_prepared_bytes,
          .reads_identity = false,
          .advance = advance_each<advance_feet>,
          .pose_whole = place,
          .whole_pose_work = foot_placement_work,
          .resource = &rig};
}

}  // namespace throng::anim
