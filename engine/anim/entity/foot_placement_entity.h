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
  AnimationStateHeader state;  //   0
  Handle source;               //  96
  float drop;                  // 100  metres that the pelvis was lowered, of the last update
  float reserved[2];           // 104
  FadingWeight weight;         // 112  0: the source's pose, to the bit
};
static_assert(sizeof(FootPlacementEntity) == entity_header_bytes);
static_assert(offsetof(FootPlacementEntity, source) == 96 && offsetof(FootPlacementEntity, weight) == 112);

/// The ground of each foot is a plane, sampled by the host where the ankle was last. The entity finds the plane's
/// height under the foot as the pose has it now: exact on a plane, however old the sample; an update late on anything
/// else. There are as many feet as the rig has legs.
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

/// The placed feet of a skeleton; the rig outlives them. A level of detail without all legs is left as it is, and where
/// feet were locked is forgotten.
EntityKind foot_placement_kind(const FootPlacementRig& rig);

}  // namespace throng::anim
