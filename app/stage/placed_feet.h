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
/// agent has the post process while its feet are placed, and until they have gone back to where the clip has them; then
/// another one gets it. So the many who are far away are posed without, and a frame allocates nothing.
class PlacedFeet {
 private:
  static constexpr std::size_t none = SIZE_MAX;
  struct Feet {
    std::size_t process = none;  // index among the agent's post processes
    bool placed = false;
  };

 public:
  /// All that changes as time passes.
  struct Moment {
    std::vector<Feet> feet;           // [agent]
    std::vector<std::uint32_t> have;  // agents with the post process
  };

  /// `kinds`: RigKinds::foot_placement of each character; nothing: it has no legs to place. `system` outlives it.
  PlacedFeet(std::vector<std::optional<anim::EntityPools::Kind>> kinds, anim::AnimationSystem& system);

  /// All agents are made anew.
  void reset(std::size_t agents);

  /// Before an update of an agent with all bones, for the pose of now: where it stands. Of one that `is_shown` already
  /// they fade to there.
  void place(const Crowd& crowd, std::uint32_t agent, bool is_shown);
  /// Before an update in which its feet go as the clip has them.
  void let_go(std::uint32_t agent);
  /// Before an update: from those who need it no more, or whom nobody sees. `visible`: by rising agent.
  void take_back(std::span<const anim::VisibleAgent> visible);

  const Moment& moment() const { return now_; }
  void go_back_to(const Moment& moment) { now_ = moment; }

 private:
  using Process = anim::FootPlacementProcess;

  bool give(std::uint32_t agent, bool is_shown);
  bool needs(std::uint32_t agent, std::span<const anim::VisibleAgent> visible) const;
  std::unique_ptr<anim::PostProcess> make(std::uint32_t character);

  std::vector<std::optional<anim::EntityPools::Kind>> kinds_;               // [character]
  std::vector<std::vector<std::unique_ptr<anim::PostProcess>>> not_given_;  // [character]
  anim::AnimationSystem* system_;
  Moment now_;
};

}  // namespace throng::app
