#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/kernel/ragdoll/ragdoll.h"

namespace throng::anim {

/// A rag-doll (paper 2.2.6, kernel/ragdoll/ragdoll.h). It passes its source on until it is let go; from then on it
/// falls and its source may be taken away. Bones without bodies keep what the source had when it was.
///
///     [header 96 | rag-doll 32 | transforms, always | RagdollMemory | a pose]
///
/// Letting go takes two updates, since movement needs two poses; both pass the source on.
///
///     animated --let_go()--> first --> second --> loose
struct alignas(64) RagdollEntity {
  enum class Phase : std::uint32_t { animated, first, second, loose };

  AnimationStateHeader state;  //   0
  Handle source;               //  96  invalid: none; only while loose
  Phase phase;                 // 100
  float impulse[3];            // 104  kg m/s, a push for the next update that is loose; zero: none
  float push_place[3];         // 116  model space: the nearest body is pushed there
};
static_assert(sizeof(RagdollEntity) == entity_header_bytes);
static_assert(offsetof(RagdollEntity, source) == 96 && offsetof(RagdollEntity, push_place) == 116);

struct alignas(64) RagdollMemory {
  RagdollState bodies;
  GroundPlane ground;         ///< model space; to be set by whoever makes the entity
  std::int32_t bones_before;  ///< that the pose behind this has: of the first update of letting go
};
static_assert(std::is_trivially_copyable_v<RagdollMemory>);

/// Takes effect with the next two updates. Nothing if it was let go already.
void let_go(RagdollEntity& ragdoll);

inline bool is_loose(const RagdollEntity& ragdoll) { return ragdoll.phase == RagdollEntity::Phase::loose; }

/// The rag-dolls of a skeleton; the rig outlives them.
EntityKind ragdoll_kind(const RagdollRig& rig);

}  // namespace throng::anim
