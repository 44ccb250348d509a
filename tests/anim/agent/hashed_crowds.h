#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "engine/anim/agent/animation_system.h"

namespace throng::anim {

/// What a crowd's hash must be, by the stream that it plays.
struct PinnedHashes {
  std::uint64_t sampled, keyframe;
};

/// A crowd that can be posed under any options, and what its hash must be.
struct HashedCrowd {
  std::string name;
  std::uint64_t (*hash_of)(const SystemOptions& options);
  std::vector<std::size_t> stores_kib;  ///< hold it under both schedules
  PinnedHashes fused;                   ///< on targets with fused multiply-add, see PoseHash.IsThePinnedOne
  PinnedHashes apart;                   ///< on targets without
};

void PrintTo(const HashedCrowd& crowd, std::ostream* stream);  ///< its name, for a test that fails

/// Returns the crowds whose hashes are pinned.
std::span<const HashedCrowd> hashed_crowds();

std::uint64_t hash_of_every_kind(const SystemOptions& options);

}  // namespace throng::anim
