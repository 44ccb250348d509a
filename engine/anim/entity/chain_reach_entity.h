#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/entity/fading_weight.h"
#include "engine/anim/kernel/limb/chain_reach.h"

namespace throng::anim {

/// Makes one chain of bones of its source reach (kernel/limb/chain_reach.h).
///
///     [header 96 | chain reach 32 | transforms if resident | ChainReachMemory]
struct alignas(64) ChainReachEntity {
  static constexpr EntityType entity_type = EntityType::chain_reach;

  AnimationStateHeader state;  //   0
  Handle source;               //  96
  float target[3];             // 100  metres, model space: the place that the end of the chain reaches for
  FadingWeight weight;         // 112  0: the source's pose, to the bit
};
static_assert(sizeof(ChainReachEntity) == entity_header_bytes);
static_assert(offsetof(ChainReachEntity, source) == 96 && offsetof(ChainReachEntity, weight) == 112);

/// Set by the code that makes the entity. See ChainReachJob.
struct ChainReachMemory {
  std::uint32_t chain;  ///< index into the kind's chains
  std::int32_t iterations;
  float tolerance;
  float missed_by;  ///< metres from the end to the target after the last update
};
static_assert(std::is_trivially_copyable_v<ChainReachMemory>);

/// Returns the chain reach kind of a skeleton. The chains outlive it. A bone level without the chain keeps the source's
/// pose.
EntityKind chain_reach_kind(const std::vector<ReachChain>& chains);

}  // namespace throng::anim
