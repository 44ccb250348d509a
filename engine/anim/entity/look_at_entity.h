#pragma once

#include <cstddef>
#include <type_traits>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/entity/fading_weight.h"
#include "engine/anim/kernel/limb/look_at.h"

namespace throng::anim {

/// Turns spine, neck and head of its source towards a target (kernel/limb/look_at.h).
///
///     [header 96 | look-at 32 | transforms if resident | LookAtMemory]
struct alignas(64) LookAtEntity {
  static constexpr EntityType entity_type = EntityType::look_at;

  AnimationStateHeader state;  //   0
  Handle source;               //  96
  float target[3];             // 100  metres, model space
  FadingWeight weight;         // 112  0: the source's pose, to the bit
};
static_assert(sizeof(LookAtEntity) == entity_header_bytes);
static_assert(offsetof(LookAtEntity, source) == 96 && offsetof(LookAtEntity, weight) == 112);

struct LookAtMemory {
  LookAtLimits limits;  ///< set by the code that makes the entity
  LookAtState gaze;
};
static_assert(std::is_trivially_copyable_v<LookAtMemory>);

/// Returns the look-at kind of a skeleton. The rig outlives it. A bone level without the head keeps the source's pose.
EntityKind look_at_kind(const LookAtRig& rig);

}  // namespace throng::anim
