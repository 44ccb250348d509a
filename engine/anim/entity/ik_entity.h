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
  AnimationStateHeader state;  //   0
  Handle source;               //  96
  float target[3];             // 100  metres, model space: where the end of the limb is to be
  FadingWeight weight;         // 112  0: the source's pose, to the bit
};
static_assert(sizeof(IkEntity) == entity_header_bytes);
static_assert(offsetof(IkEntity, source) == 96 && offsetof(IkEntity, weight) == 112);

/// See TwoBoneIkJob; to be set by whoever makes the entity.
struct IkMemory {
  std::uint32_t limb;  ///< index into the kind's limbs
  float softness;
  glm::vec3 pole;
  glm::quat end_rotation;
  bool turn_end;
  float missed_by;  ///< metres from the end to the target, of the last update
};
static_assert(std::is_trivially_copyable_v<IkMemory>);

/// The inverse kinematics of a skeleton; the limbs outlive them. A level of detail without the limb is left as it is.
EntityKind ik_kind(const std::vector<TwoBoneLimb>& limbs);

}  // namespace throng::anim
