#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/anim/asset/character.h"
#include "engine/anim/entity/ease_blender.h"
#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/entity/player.h"
#include "engine/anim/run/pose_program.h"

namespace throng::anim {

/// "Play this clip", as a user of the system says it (paper 2.1.2).
struct PlayRequest {
  int clip = 0;        ///< index into the character's clips
  Ticks fade = 0;      ///< eases in from what plays now; 0 replaces it at once (on the masked bones)
  double speed = 1.0;  ///< of the clip's own
  Ticks start = 0;     ///< position in the clip, 0 to its duration
  bool loop = true;
  std::optional<float> held_fraction = std::nullopt;  ///< instead of fading: blend for good, this much of the new clip
  /// What `AnimationSystem::add_mask` returned: the clip is laid over what plays now, on the masked bones, and stays
  /// there until a request without a mask takes the place of all. no_mask: on all bones.
  int mask = no_mask;

  static constexpr int no_mask = EaseBlender::no_mask;
};

/// The entities of one agent's blend tree: player 0, then for i = 1, 2, ... player i and the blender over it and all
/// before.
struct BlendTree {
  static constexpr int max_players = 4;
  static constexpr int max_entities = 2 * max_players - 1;

  std::array<Handle, max_entities> entities;
  std::uint8_t count = 0;

  std::span<const Handle> all() const { return {entities.data(), count}; }
  Handle root() const { return entities[count - 1U]; }
};

/// The blend trees of all agents: which players and blenders each one has, and until when its fades run.
/// Changes happen at frame boundaries, on one thread; entities are created in and returned to the pools.
class BlendTrees {
 public:
  BlendTrees(EntityPools& pools, std::span<const ClipStreams> clips) : pools_(&pools), clips_(clips) {}

  void resize(std::uint32_t agents);
  std::uint32_t agent_count() const { return static_cast<std::uint32_t>(agents_.size()); }
  const PoseProgram& program(std::uint32_t agent) const { return agents_[agent].program; }
  /// After pools changed their layouts.
  void recompile();

  /// `now` is when the request is made, `posed_at` the time that the agent's entities stand at. False: all player
  /// places of the tree are taken by fades that still run and by blends that stay.
  bool play(std::uint32_t agent, const PlayRequest& request, StreamKind stream, Ticks now, Ticks posed_at);

  /// Replaces every fade that is over at `time` by its target, so that trees stay shallow.
  void end_fades(std::uint32_t agent, Ticks time);

  /// Moves every player to the pool of the stream that it is to play from now on.
  void set_stream(StreamKind stream);

  static std::size_t bytes_per_agent() { return sizeof(Agent) + usual_steps * sizeof(PoseStep); }

 private:
  static constexpr std::size_t usual_steps = BlendTree::max_entities;

  struct Agent {
    BlendTree tree;
    PoseProgram program;
    std::array<Ticks, BlendTree::max_players> fade_end{};  // of the blender over player i; [0] unused
  };

  EntityPools::Kind player_kind(std::uint32_t clip, StreamKind stream) const;

  Handle make_player(std::uint32_t agent, const PlayRequest& request, StreamKind stream, Ticks lead);
  Handle make_blender(std::uint32_t agent, const PlayRequest& request, Handle from, Handle to, Ticks lead);
  void move_player(Agent& agent, std::size_t place, StreamKind stream);
  void compile(std::uint32_t agent);

  EntityPools* pools_;
  std::span<const ClipStreams> clips_;
  std::vector<Agent> agents_;
};

}  // namespace throng::anim
