#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/anim/agent/fitted_scheduler.h"

namespace throng::anim {

/// One agent whose exact pose is wanted.
struct ExactPose {
  AgentId agent{};
  PaletteMatrix* palette = nullptr;  ///< out, room for all entries of its skeleton, 16-byte aligned
};

/// Poses agents for the clock with all bones, and changes nothing. Level of detail is measured against these poses. It
/// has a scheduler of its own, so that a look neither fails nor depends on how the crowd is scheduled.
class ExactPoser {
 public:
  /// Does what AnimationSystem::pose_exactly does.
  void pose(const Population& population, const FittedScheduler& crowd, std::span<const ExactPose> agents);

 private:
  void list_work(const Population& population, const FittedScheduler& crowd, std::span<const ExactPose> agents);
  bool stores_hold() const;
  void make_scheduler(const Population& population, const FittedScheduler& crowd);

  std::unique_ptr<Scheduler> scheduler_;  // null until it is needed
  std::uint64_t made_for_ = 0;            // FittedScheduler::version()
  std::vector<AgentWork> work_;
  std::vector<WorkRun> runs_;  // the runs in work_
  std::vector<UpdateContext> contexts_;
};

}  // namespace throng::anim
