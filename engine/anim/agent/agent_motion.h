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
  Ticks time{};         ///< the time of the clock at which it was met
  float weight = 0.0F;  ///< the share of the clip in the agent's pose, 0 to 1
};

/// The place of a cut scene in the world: the absolute root (paper 2.2.1).
struct AbsoluteRoot {
  glm::dvec3 position{0.0};
  glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};
};

/// The weights of the steps of a program, in their order.
using PoseWeights = std::array<float, PoseProgram::max_steps>;

/// Holds the data by which the weights of morphs are blended.
struct MorphBlend {
  std::span<const int> bones{};           ///< of each morph, the bone at which masks count for it
  std::span<const float* const> masks{};  ///< each [bone]
};

/// Finds in closed form what an agent's players do between two times of the clock. The agent need not be posed, and may
/// stand ahead of the clock. It reads blocks at a frame boundary, for any number of agents at a time.
///
/// Root motion is blended as poses are, by the weights at `to`. An entity that is neither player nor blender nor mixer
/// moves as its first source does.
class AgentMotion {
 public:
  /// `posed_at` is the time at which the agent's entities stand.
  AgentMotion(const EntityPools& pools, std::span<const ClipStreams> clips, const PoseGraph& graph, Ticks posed_at,
              const MorphBlend& morphs = {})
      : pools_(&pools), clips_(clips), graph_(&graph), posed_at_(posed_at), morphs_(morphs) {}

  /// Returns the share of each step's state in the agent's pose at `at`, 0 to 1. The root has all of it, which blenders
  /// and mixers share out to the others. A state that a mask or an additive layer lays over a pose has no share.
  PoseWeights weights(Ticks at) const;

  /// Returns how the agent moved from `from` to `to`, in its own space at `from`.
  RootMotion displacement(Ticks from, Ticks to) const;

  /// Visits every data key met in [from, to), player after player, each in the order of its motion. Adjoining intervals
  /// deliver each key once.
  void for_each_data_key(Ticks from, Ticks to, const std::function<void(const DataKeyEvent&)>& visit) const;

  /// Adds the weights of the character's morphs at `at` to `weights`, which has one for each. They are blended as the
  /// pose of their bones is. Returns whether any clip that plays has morphs; else nothing is added.
  bool add_morph_weights(Ticks at, std::span<float> weights) const;

  /// Returns where the heaviest player of an absolute state stands at `now`, its own root motion included. Returns
  /// nothing if no player of weight has an absolute root.
  std::optional<AbsoluteRoot> absolute_root(Ticks now) const;

 private:
  template <typename Visit>
  void for_each_player(const PoseWeights& shares, Visit&& visit) const;
  FineTicks position(const Player& player, Ticks at) const;
  PoseWeights weights_at_bone(Ticks at, int bone) const;
  bool plays_morphs() const;
  bool differs_by_bone() const;

  const EntityPools* pools_;
  std::span<const ClipStreams> clips_;
  const PoseGraph* graph_;
  Ticks posed_at_;
  MorphBlend morphs_;
};

}  // namespace throng::anim
