#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "app/show/stage/lent_processes.h"
#include "engine/anim/agent/look_at_process.h"

namespace throng::app {

/// Heads that turn to a person. An agent has the post process while it looks at a person near by, and until its head is
/// back, so its gaze follows from the last request.
class Gazes {
 public:
  using Moment = LentProcesses<anim::LookAtProcess>::Moment;

  /// Takes RigKinds::look_at of each character; it is empty for a character without a gaze. `system` outlives this.
  Gazes(std::vector<std::optional<anim::EntityPools::Kind>> kinds, anim::AnimationSystem& system)
      : lent_(std::move(kinds), system) {}

  /// Forgets all agents and makes room for `agents`; call it when they are made anew.
  void reset(std::size_t agents) { lent_.reset(agents); }

  /// Turns the head of an agent towards a place in its model space, by a share of the way. Call it before an update of
  /// the agent with all bones, for the pose of now.
  void look(std::uint32_t agent, const glm::vec3& target, float share);
  /// Lets an agent look where its clips do. Call it before the update.
  void look_away(std::uint32_t agent);
  /// Takes the post process from agents that no longer need it, or that are not in `visible`, which ascends by agent.
  /// Call it before an update.
  void take_back(std::span<const anim::VisibleAgent> visible) { lent_.take_back(visible); }

  const Moment& moment() const { return lent_.moment(); }
  void go_back_to(const Moment& moment) { lent_.go_back_to(moment); }

 private:
  LentProcesses<anim::LookAtProcess> lent_;
};

}  // namespace throng::app
