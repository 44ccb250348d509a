#pragma once

#include <cstdint>
#include <vector>

#include "engine/anim/agent/animation_system.h"
#include "engine/crowd/palette_slots.h"
#include "engine/crowd/shown_poses.h"

namespace throng {

/// The exact poses of a moment, in palette slots of their own for one frame. A split view shows them on its left. In a
/// frame:
///     give_back(the frame that drew them)
///     add(...)      each agent that is drawn
///     pose(system)  the PUs write the slots
class ExactPoses {
 public:
  explicit ExactPoses(PaletteSlots& slots) : slots_(&slots) {}

  void reset(std::size_t agents, std::uint64_t last_frame);
  void give_back(std::uint64_t last_frame);

  /// Adds an agent whose palette with all bones has `entries`. If `entries` is 0, the exact pose is not known, and
  /// `shown` stands for it, as it does where no memory is left.
  void add(std::uint32_t agent, const ShownPose& shown, std::uint32_t entries);
  void pose(anim::AnimationSystem& system);

  /// Returns the pose of an agent that was added.
  const ShownPose& pose(std::uint32_t agent) const { return poses_[agent]; }

 private:
  PaletteSlots* slots_;
  std::vector<ShownPose> poses_;  // [agent]
  std::vector<anim::ExactPose> posed_;
};

}  // namespace throng
