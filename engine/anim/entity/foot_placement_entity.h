#pragma once

#include <cstddef>
#include <span>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/entity/fading_weight.h"
#include "engine/anim/kernel/limb/foot_placement.h"

namespace throng::anim {

/// Puts the feet of its source on uneven ground (kernel/limb/foot_placement.h).
///
///     [header 96 | foot placement 32 | transforms if resident | body 80 | a foot 112, a foot 112, ...]
struct alignas(64) FootPlacementEntity {
  static constexpr EntityType entity_type = EntityType::foot_placement;

  AnimationStateHeader state;  //   0
  Handle source;               //  96
  float drop;                  // 100  metres by which the last update lowered the pelvis
  float reserved[2];           // 104
  FadingWeight weight;         // 112  0: the source's pose, to the bit
};
static_assert(sizeof(FootPlacementEntity) == entity_header_bytes);
static_assert(offsetof(FootPlacementEntity, source) == 96 && offsetof(FootPlacementEntity, weight) == 112);

/// The ground under each foot is a plane, which the host samples where the ankle was in the last update. The entity
/// takes the plane's height under the foot's present place: exact on a plane, and one update late on other ground.
/// There are as many feet as the rig has legs.
struct FootPlacementMemory {
  PlacedBody body;
  PlacedFoot feet[max_legs];
};
static_assert(offsetof(FootPlacementMemory, feet) == sizeof(PlacedBody));

inline std::span<PlacedFoot> feet_of(const EntityKind& kind, FootPlacementMemory& memory) {
  const auto& rig = *static_cast<const FootPlacementRig*>(kind.resource);
  return {memory.feet, static_cast<std::size_t>(rig.leg_count)};
}

/// EntityKind::whole_pose_work.
inline constexpr int foot_placement_work = 3;

/// Returns the foot placement kind of a skeleton. The rig outlives it. A bone level that lacks a leg keeps the source's
/// pose and forgets where feet were locked.
EntityKind foot_placement_kind(const FootPlacementRig& rig);

}  // namespace throng::anim
