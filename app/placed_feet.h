#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/crowd.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/foot_placement_process.h"

namespace throng::app {

/// Feet that stand where they came down: turns and changes of gait move the body, not the foot that carries it. An
/// agent gets its post process when its feet are placed first, and keeps it, without weight where they are not.
class PlacedFeet {
 public:
  /// `kinds`: RigKinds::foot_placement of each character; nothing: it has no legs to place. `system` outlives it.
  PlacedFeet(std::vector<std::optional<anim::EntityPools::Kind>> kinds, anim::AnimationSystem& system)
      : kinds_(std::move(kinds)), system_(&system) {}

  /// All agents were made anew.
  void reset(std::size_t agents);

  /// Before an update of an agent with all bones, for the pose of now: where it stands.
  void place(const Crowd& crowd, std::uint32_t agent);
  /// Before an update in which its feet go as the clip has them.
  void let_go(std::uint32_t agent);

 private:
  static constexpr std::size_t none = SIZE_MAX;
  struct Feet {
    std::size_t process = none;  // index among the agent's post processes
    bool placed = false;
  };

  bool give(std::uint32_t agent);

  std::vector<std::optional<anim::EntityPools::Kind>> kinds_;  // [character]
  anim::AnimationSystem* system_;
  std::vector<Feet> feet_;  // [agent]
};

}  // namespace throng::app
