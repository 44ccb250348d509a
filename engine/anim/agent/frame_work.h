#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "throng/pose_request.h"

#include "engine/anim/agent/fitted_scheduler.h"
#include "engine/anim/run/update_report.h"

namespace throng::anim {

/// The hashes of the palettes of all updates so far.
struct FrameHashes {
  std::uint64_t frame = 0;              ///< the number of updates so far
  std::uint64_t poses = 0;              ///< the hashes of agents summed up, and of frames chained
  std::vector<std::uint64_t> agents;    ///< [agent] the hash of its last update, seeded by its place and the frame
  std::vector<std::uint64_t> palettes;  ///< [agent] the hash of its last palette alone; PUs write it
  std::vector<std::uint64_t> frames;    ///< [agent] the frame of its last update; 0: there was none
  std::uint64_t order = 0;              ///< AgentOrder::version of the places

  std::size_t bytes() const { return 3 * agents.size() * sizeof(std::uint64_t); }
};

/// Does a frame: asks the channels that are due, lists the work of each agent, has the PUs do it, and sums it up.
class FrameWork {
 public:
  void update(Population& population, FittedScheduler& pus, std::span<const PoseRequest> agents);
  /// Makes room for agents with numbers below `limit`, so that an update allocates nothing.
  void reserve(std::uint32_t limit);
  /// Forgets the agent that had this number.
  void forget_agent(std::uint32_t agent);
  /// Begins the count of frames and the pose hash anew.
  void restart();

  const UpdateReport& report() const { return report_; }
  const FrameHashes& hashes() const { return hashes_; }
  /// Takes the hashes of a snapshot.
  void restore(const FrameHashes& hashes) { hashes_ = hashes; }
  /// Returns what Figures::stream_bytes does.
  std::uint64_t stream_bytes(std::span<const UpdateContext> contexts) const;

 private:
  void list_shared_work(Population& population, FittedScheduler& pus);
  void list_work(Population& population, FittedScheduler& pus, std::span<const PoseRequest> agents);
  void report_work(const Population& population, const FittedScheduler& pus);
  bool may_update(const Population& population, std::span<const UpdateContext> contexts,
                  const PoseRequest& update) const;
  void sum_up_hashes(const AgentOrder& order);
  void hash_agent(std::uint32_t agent, std::uint32_t place);

  FrameHashes hashes_;
  std::vector<AgentWork> work_;
  std::vector<WorkRun> runs_;  // the runs in work_
  std::vector<AgentWork> shared_work_;
  std::vector<PaletteDestination> joints_to_;  // [agent] of this update, where a character lists joints
  UpdateReport report_;
};

}  // namespace throng::anim
