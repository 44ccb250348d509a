#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/run/agent_work.h"

namespace throng::anim {

/// Agents that follow each other, of one skeleton, bone level and program, who cost the same.
struct WorkRun {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// The work of a frame in the order in which tiles are cut from it (paper 3.2): groups of one skeleton and bone level,
/// held or not, whose agents cost most first; within a group the dearest agents first. Agents who cost the same stay in
/// their order.
class WorkOrder {
 public:
  /// Room for so many agents, so that nothing below allocates.
  void reserve(std::size_t agents);

  /// `work` stays where it is until the next call. A crowd of one group, which is common, is not copied.
  void sort(std::span<const AgentWork> work);

  std::span<const AgentWork> work() const { return work_; }
  /// Of work(), all of it; none can be made longer.
  std::span<const WorkRun> runs() const { return runs_; }
  /// Nanoseconds that all of it is predicted to take, without what tiles add.
  double predicted() const;

 private:
  void find_runs();
  bool is_in_order() const;

  std::span<const AgentWork> work_;
  std::vector<AgentWork> sorted_;
  std::vector<WorkRun> runs_;
};

/// They may be in one tile.
inline bool share_a_tile(const AgentWork& a, const AgentWork& b) {
  return a.skeleton == b.skeleton && a.level == b.level && a.held == b.held;
}

}  // namespace throng::anim
