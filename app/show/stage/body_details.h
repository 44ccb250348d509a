#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "app/character/source.h"
#include "app/people/crowd/crowd.h"
#include "app/show/stage/gazes.h"
#include "app/show/stage/held_arms.h"
#include "app/show/stage/joined_hands.h"
#include "app/show/stage/placed_feet.h"
#include "app/show/stage/track_players.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/character_rigs.h"
#include "engine/base/gathered.h"

namespace throng::app {

/// Poses agents beyond the clips that the crowd asks for, just before their update: steps of people who follow a file,
/// feet that stand, heads that turn, arms that hold something, hands that join. Call all of it before an
/// update.
class BodyDetails {
 public:
  /// `characters` and `rigs` have one element a character, and `kinds` is what the rigs were added with. All but
  /// `kinds` outlive this.
  BodyDetails(std::span<const CharacterSource> characters, std::span<const std::unique_ptr<anim::CharacterRigs>> rigs,
              std::span<const anim::RigKinds> kinds, anim::AnimationSystem& system);

  /// Forgets all agents, for `crowd`, which outlives this or the next reset. Call it before its agents are made.
  void reset(const Crowd& crowd);
  /// Lets agents that were just made follow the crowd's tracks.
  void follow_tracks();
  /// Finds anew which things agents hold and which children they lead by the hand. Agents are as they were made.
  void find_things();

  /// Sets what a person of a recorded crowd plays in the first of these updates. It asks the caches for the next one.
  void follow_track(std::span<const PoseRequest> updates);
  /// Lets the feet of an agent stand where they came down, or else go as the clip has them. Where they stand, the agent
  /// turns its head to the person that it talks to. Call it after follow_track(); feet stand only in an update for the
  /// pose of now.
  void place_feet(std::uint32_t agent, bool stand, bool is_shown);
  /// Takes foot placement, gazes and reaching hands from agents that no longer need them, or that are not in `visible`.
  /// Feet that foot placement let go come down anew.
  void take_back(std::span<const anim::VisibleAgent> visible);
  /// Lets arms hold their things where these can be seen, and hands join.
  void hold_things(std::span<const anim::VisibleAgent> visible);

  const HeldArms& held_arms() const { return held_arms_; }
  /// Returns the players of the people of a recorded crowd; null in the other scenes.
  const TrackPlayers* track_players() const { return track_players_ ? &*track_players_ : nullptr; }

  struct Moment {
    PlacedFeet::Moment feet;
    Gazes::Moment gazes;
    JoinedHands::Moment joined_hands;
  };
  void remember(Moment& into) const;
  void go_back_to(const Moment& moment);

 private:
  void turn_head(std::uint32_t agent);

  std::span<const CharacterSource> characters_;
  anim::AnimationSystem* system_;
  const Crowd* crowd_ = nullptr;
  PlacedFeet feet_;
  Gazes gazes_;
  HeldArms held_arms_;
  JoinedHands joined_hands_;
  std::optional<TrackPlayers> track_players_;
  Gathered<anim::VisibleAgent> near_;  // agents in view whose arms can be seen
};

}  // namespace throng::app
