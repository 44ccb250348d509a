#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/anim/agent/fitted_scheduler.h"
#include "engine/anim/base/transform.h"

namespace throng::anim {

/// One agent whose exact pose is wanted, as a palette, as local transforms, or as both. Local transforms are for a
/// network, an editor or the skeleton of another library: Bone::prefix * T * R * S is the bone in the space of its
/// parent (glTF 2.0, 3.5.3), so that they are absolute, as Bone::rest is.
struct ExactPose {
  AgentId agent{};
  PaletteMatrix* palette = nullptr;  ///< out, room for all entries of its skeleton, 16-byte aligned
  std::span<Transform> locals{};     ///< out, one a bone of its skeleton, in the skeleton's order
};

/// Poses agents for the clock with all bones, and changes nothing. Level of detail is measured against these poses. It
/// has a scheduler of its own, so that it neither fails nor depends on how the crowd is scheduled.
class ExactPoser {
 public:
  /// Does what AnimationSystem::pose_exactly does.
  void pose(const Population& population, const FittedScheduler& crowd, std::span<const ExactPose> agents);

 private:
  enum class Written : std::uint8_t { palettes, locals };
  void pose_as(Written written, const Population& population, const FittedScheduler& crowd,
               std::span<const ExactPose> agents);
  void add_work(const Population& population, const FittedScheduler& crowd, std::uint32_t agent,
                PaletteDestination destination);
  void run(Written written, const Population& population, const FittedScheduler& crowd);
  bool stores_hold() const;
  void make_scheduler(const Population& population, const FittedScheduler& crowd);

  std::unique_ptr<Scheduler> scheduler_;  // null until it is needed
  std::uint64_t made_for_ = 0;            // FittedScheduler::version()
  std::vector<AgentWork> work_;
  std::vector<WorkRun> runs_;  // the runs in work_
  std::vector<UpdateContext> contexts_;
};

}  // namespace throng::anim
