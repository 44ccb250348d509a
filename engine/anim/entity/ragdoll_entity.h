#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/kernel/ragdoll/ragdoll.h"

namespace throng::anim {

/// A rag-doll (paper 2.2.6, kernel/ragdoll/ragdoll.h). It passes its source on until it is let go. Then it falls, and
/// its source may be destroyed. Bones without bodies keep the source's last transforms.
///
///     [header 96 | rag-doll 32 | transforms, always | RagdollMemory | a pose]
///
/// Letting go takes two updates, since a velocity needs two poses. Both pass the source on.
///
///     animated --let_go()--> first --> second --> loose
struct alignas(64) RagdollEntity {
  static constexpr EntityType entity_type = EntityType::ragdoll;
  enum class Phase : std::uint32_t { animated, first, second, loose };

  AnimationStateHeader state;  //   0
  Handle source;               //  96  may be invalid while loose
  Phase phase;                 // 100
  float impulse[3];            // 104  kg m/s, the push of the next loose update; zero: none
  float push_place[3];         // 116  model space: where the push meets the nearest body
};
static_assert(sizeof(RagdollEntity) == entity_header_bytes);
static_assert(offsetof(RagdollEntity, source) == 96 && offsetof(RagdollEntity, push_place) == 116);

struct alignas(64) RagdollMemory {
  RagdollState bodies;
  GroundPlane ground;         ///< model space; set by the code that makes the entity
  std::int32_t bones_before;  ///< bones of the pose behind this struct, which the first update of letting go keeps
};
static_assert(std::is_trivially_copyable_v<RagdollMemory>);

/// Lets the rag-doll go over the next two updates. Does nothing if it was let go already.
void let_go(RagdollEntity& ragdoll);

inline bool is_loose(const RagdollEntity& ragdoll) { return ragdoll.phase == RagdollEntity::Phase::loose; }

/// Returns the rag-doll kind of a skeleton. The rig outlives it.
EntityKind ragdoll_kind(const RagdollRig& rig);

}  // namespace throng::anim
