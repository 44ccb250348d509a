#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/people/crowd/crowd.h"
#include "app/show/stage/lent_processes.h"
#include "engine/anim/agent/foot_placement_process.h"

namespace throng::app {

/// Feet that stand where they came down: turns and changes of gait move the body, not the foot that carries it. An
/// agent has the post process while its feet are placed and until they have gone back to where the clip has them; then
/// another agent gets it. The many agents far away are posed without it, and a frame allocates nothing.
class PlacedFeet {
 public:
  using Moment = LentProcesses<anim::FootPlacementProcess>::Moment;

  /// Takes RigKinds::foot_placement of each character; it is empty for a character without legs to place. `system`
  /// outlives this.
  PlacedFeet(std::vector<std::optional<anim::EntityPools::Kind>> kinds, anim::AnimationSystem& system)
      : lent_(std::move(kinds), system) {}

  /// Forgets all agents and makes room for `agents`; call it when they are made anew.
  void reset(std::size_t agents) { lent_.reset(agents); }

  /// Lets the feet of an agent stand where they came down. The feet of an agent that `is_shown` already fade to there.
  /// Call it before an update of the agent with all bones, for the pose of now. `planted` says of each leg how firmly
  /// it stands; without it, feet go by their height in the pose.
  void place(const Crowd& crowd, std::uint32_t agent, bool is_shown, std::span<const float> planted = {});
  /// Lets the feet of an agent go as the clip has them. Call it before the update.
  void let_go(std::uint32_t agent);
  /// Takes the post process from agents that no longer need it, or that are not in `visible`, which ascends by agent.
  /// Call it before an update.
  void take_back(std::span<const anim::VisibleAgent> visible) { lent_.take_back(visible); }

  const Moment& moment() const { return lent_.moment(); }
  void go_back_to(const Moment& moment) { lent_.go_back_to(moment); }

 private:
  LentProcesses<anim::FootPlacementProcess> lent_;
};

}  // namespace throng::app
