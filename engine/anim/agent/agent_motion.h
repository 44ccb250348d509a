#pragma once

#include <functional>
#include <optional>
#include <span>

#include "engine/anim/agent/pose_weights.h"
#include "engine/anim/asset/root_curve.h"
#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/entity/player.h"

namespace throng::anim {

/// A data key that an agent has met (paper 2.2.2: "animators put specific info key-frames in the animation for game
/// play purposes").
struct DataKeyEvent {
  std::uint32_t name = 0;  ///< index of Character::data_key_names
  std::uint32_t clip = 0;
  Ticks time{};         ///< the time of the clock at which it was met
  float weight = 0.0F;  ///< how much of the clip is felt, 0 to 1: its largest share in the pose of any bone
};

/// Says which of the data keys that were met are delivered.
enum class KeyChoice : unsigned char {
  felt,      ///< keys of clips that have some weight
  heaviest,  ///< keys of the clip with the largest weight alone
  all        ///< keys of clips without weight too
};

/// A clip that does not loop has reached its end, or its start where it plays backwards.
struct ClipEnd {
  std::uint32_t clip = 0;
  Ticks time{};         ///< the time of the clock at which it arrived
  float weight = 0.0F;  ///< as in DataKeyEvent
};

/// The place of a cut scene in the world: the absolute root (paper 2.2.1).
struct AbsoluteRoot {
  glm::dvec3 position{0.0};
  glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};
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

  /// Returns how the agent moved from `from` to `to`, in its own space at `from`: over the ground, up and down, and by
  /// how much it turned. While weights stay, the motions of adjoining intervals compose to the motion of the whole.
  RootMotion displacement(Ticks from, Ticks to) const;

  /// Visits the data keys met in [from, to), player after player, each in the order of its motion. Adjoining intervals
  /// deliver each key once. Weights hold at `to`. Under a mask a clip has the weight of its heaviest
  /// bone.
  ///
  /// Gaits that keep step in a blend space meet the same key together: the leader delivers it, with the weight of all.
  void for_each_data_key(Ticks from, Ticks to, const std::function<void(const DataKeyEvent&)>& visit,
                         KeyChoice choice = KeyChoice::felt) const;

  /// Visits each clip that does not loop and arrived at its end in (from, to], or at its start where it plays
  /// backwards, whatever its weight. Adjoining intervals deliver each arrival once; a clip that begins there has none.
  void for_each_end(Ticks from, Ticks to, const std::function<void(const ClipEnd&)>& visit) const;

  /// Adds the weights of the character's morphs at `at` to `weights`, which has one for each. They are blended as the
  /// pose of their bones is. Returns whether any clip that plays has morphs; else nothing is added.
  bool add_morph_weights(Ticks at, std::span<float> weights) const;

  /// Returns the value of a curve at `at`, for game play; `name` is an index of Character::curve_names. It is blended
  /// by how much its clips are felt, as data keys are, and a clip without the curve counts as 0. Where clips under a
  /// mask are felt beside others, so that all together weigh more than 1, it is their mean.
  float curve(std::uint32_t name, Ticks at) const;

  /// Returns where the heaviest player of an absolute state stands at `now`, its own root motion included. Returns
  /// nothing if no player of weight has an absolute root.
  std::optional<AbsoluteRoot> absolute_root(Ticks now) const;

 private:
  PoseSharing sharing(Ticks at) const { return {*pools_, *graph_, morphs_, at - posed_at_}; }
  /// Calls visit(step, player, clip) for each player, the root's side first.
  template <typename Visit>
  void for_each_player(Visit&& visit) const {
    for (std::size_t step = graph_->entities.size(); step-- > 0;) {
      if (is_player(step)) visit(step, player(step), clips_[player(step).clip]);
    }
  }
  bool is_player(std::size_t step) const {
    const std::uint32_t kind = graph_->entities[step].pool();
    return kind == EntityPools::sampled_players || kind == EntityPools::keyframe_players;
  }
  const Player& player(std::size_t step) const { return pools_->as<Player>(graph_->entities[step]); }
  FineTicks position(const Player& player, Ticks at) const;
  RootMotion displacement_of(std::size_t step, Ticks from, Ticks to) const;
  RootMotion blended_turn(const PoseWeights& shares, Ticks from, Ticks to, double most_turn) const;
  FineTicks place_on_root_curve(std::size_t step, Ticks at) const;
  std::optional<std::size_t> leader_of(std::size_t step) const;
  float weight_of_key(std::size_t step, std::uint32_t name, const PoseWeights& felt) const;
  std::size_t heaviest_player(const PoseWeights& felt) const;
  void visit_data_keys(std::size_t step, Ticks from, Ticks to,
                       const std::function<void(const DataKey&, Ticks)>& visit) const;
  bool plays_morphs() const;
  bool differs_by_bone() const;

  const EntityPools* pools_;
  std::span<const ClipStreams> clips_;
  const PoseGraph* graph_;
  Ticks posed_at_;
  MorphBlend morphs_;
};

}  // namespace throng::anim
