#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>

#include "engine/anim/asset/root_curve.h"
#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/entity/player.h"
#include "engine/anim/run/program/pose_program.h"

namespace throng::anim {

/// A data key that an agent has met (paper 2.2.2: "animators put specific info key-frames in the animation for game
/// play purposes").
struct DataKeyEvent {
  std::uint32_t name = 0;  ///< index of Character::data_key_names
  std::uint32_t clip = 0;
  Ticks time = 0;       ///< of the clock, when it was met
  float weight = 0.0F;  ///< how much of the clip is in the agent's pose, 0 to 1
};

/// Where a cut scene stands in the world: the absolute root (paper 2.2.1).
struct AbsoluteRoot {
  glm::dvec3 position{0.0};
  glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};
};

/// Of each step of a program, in its order.
using PoseWeights = std::array<float, PoseProgram::max_steps>;

/// What an agent's players do between two times of the clock, as closed forms: the agent need not be posed, and may
/// stand ahead of the clock. Reads blocks at a frame boundary, any number of agents at a time.
///
/// Root motion is blended as poses are, by the weights at `to`. What is neither player nor blender nor mixer moves as
/// its first source does.
class AgentMotion {
 public:
  /// `posed_at`: where the agent's entities stand.
  AgentMotion(const EntityPools& pools, std::span<const ClipStreams> clips, const PoseGraph& graph, Ticks posed_at)
      : pools_(&pools), clips_(clips), graph_(&graph), posed_at_(posed_at) {}

  /// How much of each step's state is in the agent's pose at `at`, 0 to 1: all of the root, of the others as blenders
  /// and mixers share it out. What a mask or an additive layer lays over a pose has no share in it.
  PoseWeights weights(Ticks at) const;

  /// From where the agent stood at `from`, in its own space.
  RootMotion displacement(Ticks from, Ticks to) const;

  /// Every data key met in [from, to), player after player, each in the order of its motion. Adjoining intervals
  /// deliver each key once.
  void for_each_data_key(Ticks from, Ticks to, const std::function<void(const DataKeyEvent&)>& visit) const;

  /// Where the heaviest player of an absolute state stands at `now`, its own root motion included; none if no player of
  /// weight has one.
  std::optional<AbsoluteRoot> absolute_root(Ticks now) const;

 private:
  template <typename Visit>
  void for_each_player(Ticks at, Visit&& visit) const;
  FineTicks position(const Player& player, Ticks at) const;

  const EntityPools* pools_;
  std::span<const ClipStreams> clips_;
  const PoseGraph* graph_;
  Ticks posed_at_;
};

}  // namespace throng::anim
