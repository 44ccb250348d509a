#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/agent/system_parts.h"

namespace throng::anim {

/// The figures of an AnimationSystem: what it did, and what it takes. It is as cheap to copy as a pointer.
class Figures {
 public:
  explicit Figures(const SystemParts& system) : system_(&system) {}

  // The last update.
  const UpdateReport& report() const { return system_->frame.report(); }
  /// Returns the PUs, which tell what each of them did; see SystemOptions::trace.
  std::span<const ProcessingUnit> units() const { return system_->pus.scheduler().units(); }
  const UpdateTime& update_time() const { return system_->pus.scheduler().time(); }
  /// Returns the bytes of streams that the players read, counted for each reader (paper 2.2.3: the resource that stays
  /// shared). These are the two rows around the time for a sampled stream, and the share of its keys that
  /// the time passed over for a keyframe stream.
  std::uint64_t stream_bytes() const { return system_->frame.stream_bytes(system_->pus.contexts()); }

  // All updates so far.
  /// Returns the hash of all palettes: an agent's hash is seeded by agent and frame, summed over agents, and chained
  /// over frames.
  std::uint64_t pose_hash() const { return system_->frame.hashes().poses; }
  /// Returns [agent] the hash of its last update, which pose_hash() sums up.
  std::span<const std::uint64_t> agent_hashes() const { return system_->frame.hashes().agents; }

  // The ways in which the system runs.
  const ScheduleOptions& schedule() const { return system_->pus.scheduler().options(); }
  const Kernels& kernels() const { return *system_->pus.contexts().front().assets.kernels; }

  // Memory.
  /// Returns the main memory of an agent, without palettes: blocks and bookkeeping.
  double bytes_per_agent() const;
  /// Returns the memory of all blocks, in the order of the kinds. Allocates.
  std::vector<KindMemory> memory() const;

 private:
  const SystemParts* system_;
};

}  // namespace throng::anim
