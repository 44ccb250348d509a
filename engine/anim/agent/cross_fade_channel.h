#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "engine/anim/agent/channel.h"
#include "engine/anim/entity/inertialiser.h"

namespace throng::anim {

/// "Play this clip", as a user of the system says it (paper 2.1.2).
struct PlayRequest {
  int clip = 0;        ///< index into the character's clips
  Ticks fade{};        ///< eases in from what plays now; 0 replaces it at once (on the masked bones)
  double speed = 1.0;  ///< multiple of the clip's own speed; negative: backwards
  Ticks start{};       ///< position in the clip, 0 to its duration
  bool loop = true;
  std::optional<float> held_fraction = std::nullopt;  ///< instead of fading: blend for good, this much of the new clip
  /// The number that `Characters::add_mask` returned. The clip is laid over what plays now, on the masked bones, and
  /// stays there until a request without a mask takes the place of all. no_mask: it plays on all bones.
  int mask = no_mask;

  /// The place where the agent stands in a cut scene. It moves on from here by the clip's own root motion.
  std::optional<AbsoluteRoot> absolute_root = std::nullopt;
  std::uint32_t bone_selection = Player::every_bone;  ///< the number that `Characters::add_bone_selection` returned

  static constexpr int no_mask = EaseBlender::no_mask;
};

/// Returns how the player of a request begins.
PlayerStart start_of(const PlayRequest& request);

/// The entities of a blend tree that grows to one side: player 0, then player i and the blender over it and all before,
/// for i = 1, 2, ...
struct BlendTree {
  static constexpr int max_players = 4;
  static constexpr int max_entities = 2 * max_players - 1;

  std::array<Handle, max_entities> entities;
  std::uint8_t count = 0;

  bool empty() const { return count == 0; }
  std::span<const Handle> all() const& { return {entities.data(), count}; }
  std::span<const Handle> all() && = delete;  ///< a loop over them would outlive them
  Handle root() const { return count == 0 ? Handle{} : entities[count - 1U]; }
  std::size_t player_count() const { return (count + 1U) / 2U; }
  void destroy(const EntityBuilder& build);
};

// An inertialiser leaves an interrupted fade behind. Channels whose entities are a tree share these functions. The
// inertialiser is invalid, and `left` empty, where nothing was interrupted.

/// Moves the entities of `tree` to `left`, which the inertialiser leaves from now on; retarget() says for what.
template <typename Tree>
void begin_interruption(const EntityBuilder& build, Handle& inertialiser, Tree& tree, Tree& left) {
  if (!inertialiser.valid()) inertialiser = build.create(EntityPools::inertialisers);
  if (left.empty()) {
    left = tree;
  } else {
    tree.destroy(build);  // interrupted before it was ever shown
  }
  tree = {};
}

/// Lets go of the left tree once the inertialiser has seen it, and of the inertialiser once its offset has ended.
/// Returns whether it let go of anything.
template <typename Tree>
bool end_interruption(const EntityBuilder& build, Handle& inertialiser, Tree& left) {
  if (!inertialiser.valid()) return false;
  auto& own = build.as<Inertialiser>(inertialiser);
  if (!has_left(own)) return false;
  const bool lets_go = !left.empty();
  left.destroy(build);
  own.leaving = {};
  if (!is_over(own)) return lets_go;
  build.destroy(std::exchange(inertialiser, {}));
  return true;
}

/// Ends an interruption at once.
template <typename Tree>
void cut_interruption(const EntityBuilder& build, Handle& inertialiser, Tree& left) {
  left.destroy(build);
  if (inertialiser.valid()) build.destroy(std::exchange(inertialiser, {}));
}

/// Plays a clip, and fades to the next. An interrupted fade neither snaps nor waits: an inertialiser leaves the
/// shown pose behind, so that at most two fades are evaluated at once, whatever the requests.
///
///     player <- ease blender <- player                a fade
///     inertialiser <- player                          interrupted; for two updates it reads the old fade too
class CrossFadeChannel final : public Channel {
 public:
  /// Takes a request. Returns false if the request is to stay (masked or held) and the tree is full; all other requests
  /// are taken.
  bool play(const EntityBuilder& build, const PlayRequest& request);

  /// Returns the player of the clip asked for last; invalid: it plays nothing.
  Handle newest_player() const;

  Handle state() const override { return inertialiser_.valid() ? inertialiser_ : tree_.root(); }
  bool update(const EntityBuilder& build) override;
  Ticks next_update() const override;
  void visit_handles(const std::function<void(Handle&)>& visit) override;
  void destroy_entities(const EntityBuilder& build) override;
  std::unique_ptr<Channel> clone() const override { return std::make_unique<CrossFadeChannel>(*this); }

 private:
  void cut(const EntityBuilder& build, const PlayRequest& request);
  void lay_over(const EntityBuilder& build, const PlayRequest& request, Ticks fade_end);
  void interrupt(const EntityBuilder& build, const PlayRequest& request);
  bool end_fades(const EntityBuilder& build);
  bool is_fading(Ticks now) const;

  BlendTree tree_;
  std::array<Ticks, BlendTree::max_players> fade_end_{};  // [i] the end of the blender over player i; [0] unused
  BlendTree left_;                                        // the tree that the inertialiser is leaving
  Handle inertialiser_;
  Ticks settled_at_{};  // when the newest interruption settles, by the clock, so it depends on no pose
};

}  // namespace throng::anim
