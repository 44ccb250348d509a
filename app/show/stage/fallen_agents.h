#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/ragdoll_process.h"
#include "engine/base/result.h"

namespace throng::app {

/// Agents that were pushed over. They fall as rag-dolls, lie still for two seconds, and fade back to their clips. An
/// agent that has fallen must stay where it is and be posed every frame, with all bones and without looking ahead.
class FallenAgents {
 public:
  using Phase = anim::RagdollProcess::Phase;
  struct Fallen {
    std::uint32_t agent = 0;
    Ticks pushed_at{};
    Ticks rests_since = anim::never;
  };

  /// Takes RigKinds::ragdoll of each character; it is empty for a character that cannot fall. `system` outlives this.
  FallenAgents(std::vector<std::optional<anim::EntityPools::Kind>> kinds, anim::AnimationSystem& system)
      : kinds_(std::move(kinds)), system_(&system) {}

  /// Returns whether the skeleton of the agent's character can be a rag-doll.
  bool possible(std::uint32_t agent) const { return kinds_[system_->agent(agent).character_number()].has_value(); }

  /// Pushes an agent with `impulse` (kg m/s), which meets it at `place`; both are in the agent's model space. An agent
  /// that lies already is pushed again. Errors: the local store has no room for a rag-doll.
  Status push(std::uint32_t agent, const glm::vec3& impulse, const glm::vec3& place);

  /// Lets agents that lay long enough get up. Returns the agents that stand again; the span is valid until the next
  /// call. Call it after each update of the system.
  std::span<const std::uint32_t> advance();

  /// Forgets all agents and makes room for `agents`; call it when they are made anew.
  void reset(std::size_t agents) {
    fallen_.clear();
    processes_.clear();
    left_out_.assign(agents, 0);
  }

  std::span<const Fallen> fallen() const { return fallen_; }
  /// Returns the agents that have fallen as LodCrowd::left_out takes them.
  std::span<const std::uint8_t> left_out() const { return left_out_; }
  Phase phase(std::uint32_t agent) const;
  /// Returns whether the agent lies and does not move.
  bool at_rest(std::uint32_t agent) const;
  /// Returns where the hips are, in model space; nothing unless the agent is down or recovering.
  std::optional<glm::vec3> hips(std::uint32_t agent) const;

 private:
  /// The post process that an agent was given when it was first pushed.
  struct Process {
    std::uint32_t agent;
    ProcessId id;
  };

  std::optional<ProcessId> process_of(std::uint32_t agent) const;
  const anim::RagdollProcess& process(std::uint32_t agent) const;
  bool wants_up(Fallen& fallen) const;

  std::vector<std::optional<anim::EntityPools::Kind>> kinds_;  // [character]
  anim::AnimationSystem* system_;
  std::vector<Fallen> fallen_;
  std::vector<Process> processes_;
  std::vector<std::uint32_t> risen_;
  std::vector<std::uint8_t> left_out_;  // [agent] 1: is one of fallen_
};

}  // namespace throng::app
