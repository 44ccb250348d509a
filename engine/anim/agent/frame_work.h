#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/agent/fitted_scheduler.h"
#include "engine/anim/run/agent_update.h"

namespace throng::anim {

/// What the last update did.
struct UpdateReport {
  std::uint32_t agents_updated = 0;
  std::uint64_t bones_evaluated = 0;
  std::uint64_t palette_bytes = 0;
  double predicted_nanoseconds = 0;  ///< of one PU, by SystemOptions::cost: agents, and tiles as wide as they come
  CopyCounts copies;
};

/// Hashes of the palettes of all updates so far.
struct FrameHashes {
  std::uint64_t frame = 0;            ///< updates so far
  std::uint64_t poses = 0;            ///< agents summed up, frames chained
  std::vector<std::uint64_t> agents;  ///< [agent] of its last update, seeded by agent and frame

  std::size_t bytes() const { return agents.size() * sizeof(std::uint64_t); }
};

/// A frame: asks the channels that are due, lists the work of each agent, has the PUs do it, and sums it up.
class FrameWork {
 public:
  void update(Population& population, FittedScheduler& pus, std::span<const AgentUpdate> agents);
  /// Makes room for so many agents, so that an update allocates nothing.
  void reserve(std::uint32_t agents);
  /// Frames and hashes begin anew.
  void restart();

  const UpdateReport& report() const { return report_; }
  const FrameHashes& hashes() const { return hashes_; }
  /// Takes the hashes of a snapshot.
  void restore(const FrameHashes& hashes) { hashes_ = hashes; }
  /// See Figures::stream_bytes.
  std::uint64_t stream_bytes(std::span<const UpdateContext> contexts) const;

 private:
  void list_shared_work(Population& population, FittedScheduler& pus);
  void list_work(Population& population, FittedScheduler& pus, std::span<const AgentUpdate> agents);
  void report_work(const Population& population, const FittedScheduler& pus);
  void sum_up_hashes();

  FrameHashes hashes_;
  std::vector<AgentWork> work_;
  std::vector<WorkRun> runs_;  // in it
  std::vector<AgentWork> shared_work_;
  UpdateReport report_;
};

}  // namespace throng::anim
