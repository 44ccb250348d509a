#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/agent/system_parts.h"

namespace throng::anim {

/// What an AnimationSystem did and what it takes, in numbers. It is as cheap to copy as a pointer.
class Figures {
 public:
  explicit Figures(const SystemParts& system) : system_(&system) {}

  // The last update.
  const UpdateReport& report() const { return system_->frame.report(); }
  /// Tells what each PU did; see SystemOptions::trace.
  std::span<const ProcessingUnit> units() const { return system_->pus.scheduler().units(); }
  const UpdateTime& update_time() const { return system_->pus.scheduler().time(); }
  /// The bytes of streams that the players read, however often several read the same (paper 2.2.3: the resource that
  /// stays shared): of a sampled stream the two rows around the time, of a keyframe stream the share of its keys that
  /// the time passed over.
  std::uint64_t stream_bytes() const { return system_->frame.stream_bytes(system_->pus.contexts()); }

  // All updates so far.
  /// Hashes all palettes: an agent's hash is seeded by agent and frame, summed over agents, and chained over frames.
  std::uint64_t pose_hash() const { return system_->frame.hashes().poses; }
  /// [agent] the hash of its last update, which pose_hash() sums up.
  std::span<const std::uint64_t> agent_hashes() const { return system_->frame.hashes().agents; }

  // How it runs.
  const ScheduleOptions& schedule() const { return system_->pus.scheduler().options(); }
  const Kernels& kernels() const { return *system_->pus.contexts().front().assets.kernels; }

  // Memory.
  /// Main memory of an agent, without palettes: blocks and bookkeeping.
  double bytes_per_agent() const;
  /// The memory of all blocks, in the order of the kinds. The call allocates.
  std::vector<KindMemory> memory() const;

 private:
  const SystemParts* system_;
};

}  // namespace throng::anim
