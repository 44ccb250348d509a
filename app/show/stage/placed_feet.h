#pragma once

#include <cstdint>
#include <span>

#include "app/people/crowd/crowd.h"
#include "app/show/stage/lent_processes.h"
#include "engine/anim/agent/foot_placement_process.h"

namespace throng::app {

/// Feet that stand where they came down: turns and changes of gait move the body, not the foot that carries it. An
/// agent has the post process while its feet are placed and until they have gone back to where the clip has them; then
/// another agent gets it. The many agents far away are posed without it, and a frame allocates nothing.
class PlacedFeet : public LentProcesses<anim::FootPlacementProcess> {
 public:
  /// Takes RigKinds::foot_placement of each character; it is empty for a character without legs to place. `system`
  /// outlives this.
  using LentProcesses::LentProcesses;

  /// Lets the feet of an agent stand where they came down. The feet of an agent that `is_shown` already fade to there.
  /// Call it before an update of the agent with all bones, for the pose of now. `planted` says of each leg how firmly
  /// it stands; without it, feet go by their height in the pose.
  void place(const Crowd& crowd, std::uint32_t agent, bool is_shown, std::span<const float> planted = {});
  /// Lets the feet of an agent go as the clip has them. Call it before the update.
  void let_go(std::uint32_t agent);
};

}  // namespace throng::app
