#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/entity/fading_weight.h"
#include "engine/anim/kernel/limb/two_bone_ik.h"

namespace throng::anim {

/// Makes one limb of its source reach (kernel/limb/two_bone_ik.h).
///
///     [header 96 | inverse kinematics 32 | transforms if resident | IkMemory]
struct alignas(64) IkEntity {
  static constexpr EntityType entity_type = EntityType::two_bone_ik;

  AnimationStateHeader state;  //   0
  Handle source;               //  96
  float target[3];             // 100  metres, model space: the place that the end of the limb reaches for
  FadingWeight weight;         // 112  0: the source's pose, to the bit
};
static_assert(sizeof(IkEntity) == entity_header_bytes);
static_assert(offsetof(IkEntity, source) == 96 && offsetof(IkEntity, weight) == 112);

/// Set by the code that makes the entity. See TwoBoneIkJob.
struct IkMemory {
  std::uint32_t limb;  ///< index into the kind's limbs
  float softness;
  glm::vec3 pole;
  glm::quat end_rotation;
  bool turn_end;
  float missed_by;  ///< metres from the end to the target after the last update
};
static_assert(std::is_trivially_copyable_v<IkMemory>);

/// Returns the inverse kinematics kind of a skeleton. The limbs outlive it. A bone level without the limb keeps the
/// source's pose.
EntityKind ik_kind(const std::vector<TwoBoneLimb>& limbs);

}  // namespace throng::anim
