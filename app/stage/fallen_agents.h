#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/ragdoll_process.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Agents that were pushed over. They fall as rag-dolls, lie still for two seconds, and fade back to their clips. Who
/// falls is to stay where it is and to be posed every frame, with all bones and without looking ahead.
class FallenAgents {
 public:
  using Phase = anim::RagdollProcess::Phase;
  struct Fallen {
    std::uint32_t agent = 0;
    anim::Ticks pushed_at = 0;
    anim::Ticks rests_since = anim::never;
  };

  /// `kinds`: RigKinds::ragdoll of each character; nothing: nobody of it can fall. `system` outlives it.
  FallenAgents(std::vector<std::optional<anim::EntityPools::Kind>> kinds, anim::AnimationSystem& system)
      : kinds_(std::move(kinds)), system_(&system) {}

  /// The skeleton of the agent's character can be a rag-doll.
  bool possible(std::uint32_t agent) const { return kinds_[system_->agent(agent).character_number()].has_value(); }

  /// `impulse` (kg m/s) and the `place` that it meets, in the agent's model space; one who lies already is pushed
  /// again. Errors: the local store has no room for a rag-doll.
  anim::Status push(std::uint32_t agent, const glm::vec3& impulse, const glm::vec3& place);

  /// After each update of the system: lets those get up who lay long enough. Those who stand again; valid until the
  /// next call.
  std::span<const std::uint32_t> advance();

  /// All agents were made anew.
  void reset() {
    fallen_.clear();
    processes_.clear();
  }

  std::span<const Fallen> fallen() const { return fallen_; }
  Phase phase(std::uint32_t agent) const;
  /// It lies and does not move.
  bool at_rest(std::uint32_t agent) const;
  /// Where the hips are, model space; nothing before the rag-doll is loose.
  std::optional<glm::vec3> hips(std::uint32_t agent) const;

 private:
  /// A post process that an agent was given when it was pushed first.
  struct Process {
    std::uint32_t agent;
    std::size_t index;
  };

  std::optional<std::size_t> process_of(std::uint32_t agent) const;
  const anim::RagdollProcess& process(std::uint32_t agent) const;
  bool wants_up(Fallen& fallen) const;

  std::vector<std::optional<anim::EntityPools::Kind>> kinds_;  // [character]
  anim::AnimationSystem* system_;
  std::vector<Fallen> fallen_;
  std::vector<Process> processes_;
  std::vector<std::uint32_t> risen_;
};

}  // namespace throng::app
