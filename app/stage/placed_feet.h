#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/crowd/crowd.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/foot_placement_process.h"
#include "engine/anim/lod/lod.h"

namespace throng::app {

/// Feet that stand where they came down: turns and changes of gait move the body, not the foot that carries it. An
/// agent has the post process while its feet are placed and until they have gone back to where the clip has them; then
/// another agent gets it. So the many agents far away are posed without it, and a frame allocates nothing.
class PlacedFeet {
 private:
  struct Feet {
    anim::ProcessId process;  // invalid: none
    bool placed = false;
  };

 public:
  /// All of it that changes as time passes.
  struct Moment {
    std::vector<Feet> feet;           // [agent]
    std::vector<std::uint32_t> have;  // agents with the post process
  };

  /// Takes RigKinds::foot_placement of each character; it is empty for a character without legs to place. `system`
  /// outlives this.
  PlacedFeet(std::vector<std::optional<anim::EntityPools::Kind>> kinds, anim::AnimationSystem& system);

  /// Forgets all agents and makes room for `agents`; call it when they are made anew.
  void reset(std::size_t agents);

  /// Lets the feet of an agent stand where they came down. The feet of an agent that `is_shown` already fade to there.
  /// Call it before an update of the agent with all bones, for the pose of now. `planted` says of each leg how firmly
  /// it stands; without it, feet go by the height that the pose has them at.
  void place(const Crowd& crowd, std::uint32_t agent, bool is_shown, std::span<const float> planted = {});
  /// Lets the feet of an agent go as the clip has them. Call it before the update.
  void let_go(std::uint32_t agent);
  /// Takes the post process from agents that no longer need it, or that are not in `visible`, which ascends by agent.
  /// An agent keeps it while another post process comes after it. Call it before an update.
  void take_back(std::span<const anim::VisibleAgent> visible);
  /// Lets everybody's feet come down anew, where nobody was before. Call it when people are elsewhere at once.
  void forget_places() { take_back({}); }

  const Moment& moment() const { return now_; }
  void go_back_to(const Moment& moment) { now_ = moment; }

 private:
  using Process = anim::FootPlacementProcess;

  bool give(std::uint32_t agent, bool is_shown);
  bool needs(std::uint32_t agent, std::span<const anim::VisibleAgent> visible) const;
  std::unique_ptr<Process> make(std::uint32_t character);

  std::vector<std::optional<anim::EntityPools::Kind>> kinds_;     // [character]
  std::vector<std::vector<std::unique_ptr<Process>>> not_given_;  // [character]
  anim::AnimationSystem* system_;
  Moment now_;
};

}  // namespace throng::app
