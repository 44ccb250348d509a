#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/run/program/agent_work.h"

namespace throng::anim {

/// Agents that follow each other, and have one skeleton, bone level, program and cost.
struct WorkRun {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// Finds the runs of all of `work`, in its order. No run can be made longer.
void find_runs(std::span<const AgentWork> work, std::vector<WorkRun>& runs);

/// The work of a frame, and the runs in it.
struct WorkInRuns {
  std::span<const AgentWork> work;
  std::span<const WorkRun> runs;
};

/// The work of a frame in the order in which tiles are cut from it (paper 3.2). A group is of one skeleton and bone
/// level, held or streaming. Groups whose agents cost most are first, and within a group the dearest agents. Agents
/// of equal cost stay in their order.
class WorkOrder {
 public:
  /// Makes room for so many agents, so that sort() does not allocate.
  void reserve(std::size_t agents);

  /// Sorts the given work, which stays where it is until the next call. A crowd of one group, which is common, is not
  /// copied.
  void sort(const WorkInRuns& given);

  std::span<const AgentWork> work() const { return ordered_.work; }
  std::span<const WorkRun> runs() const { return ordered_.runs; }
  /// Returns the predicted nanoseconds of all work, without the tiles' own.
  double predicted() const;

 private:
  bool is_in_order() const;

  WorkInRuns ordered_;
  std::vector<AgentWork> sorted_;
  std::vector<WorkRun> sorted_runs_;
};

/// Returns whether both may be in one tile.
inline bool share_a_tile(const AgentWork& a, const AgentWork& b) {
  return a.skeleton == b.skeleton && a.level == b.level && a.held == b.held;
}

}  // namespace throng::anim
