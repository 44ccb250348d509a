#pragma once

#include <cstddef>
#include <type_traits>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/entity/fading_weight.h"
#include "engine/anim/kernel/foot_placement.h"

namespace throng::anim {

/// Puts the feet of its source on uneven ground (kernel/foot_placement.h).
///
///     [header 96 | foot placement 32 | transforms if resident | FootPlacementMemory]
struct alignas(64) FootPlacementEntity {
  AnimationStateHeader state;  //   0
  Handle source;               //  96
  float drop;                  // 100  metres that the pelvis was lowered, of the last update
  float reserved[2];           // 104
  FadingWeight weight;         // 112  0: the source's pose, to the bit
};
static_assert(sizeof(FootPlacementEntity) == entity_header_bytes);
static_assert(offsetof(FootPlacementEntity, source) == 96 && offsetof(FootPlacementEntity, weight) == 112);

/// The ground of each leg is a plane, sampled by the host where the ankle was last. The entity finds the plane's height
/// under the ankle as the pose has it now: exact on a plane, however old the sample; an update late on anything else.
struct FootPlacementMemory {
  // To be set by whoever makes the entity, and at any frame boundary.
  Footing ground[max_legs];    ///< world space
  float planted[max_legs];     ///< 0 to 1, or planted_by_pose
  JointMotion model_in_world;  ///< turned about the vertical only
  FootPlacementOptions options;
  // Of the last update.
  FootPlacementState feet;
  glm::vec3 ankles[max_legs];  ///< model space, as the source has them: where to sample the ground
  float missed_by[max_legs];   ///< metres that the ankle is from where it should be
};
static_assert(std::is_trivially_copyable_v<FootPlacementMemory>);

/// EntityKind::whole_pose_work.
inline constexpr int foot_placement_work = 16;

/// The placed feet of a skeleton; the rig outlives them. A level of detail without all legs is left as it is, and where
/// feet were locked is forgotten.
EntityKind foot_placement_kind(const FootPlacementRig& rig);

}  // namespace throng::anim
