#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "throng/host.h"
#include "throng/ticks.h"

#include "app/character/roles.h"
#include "app/people/crowd/cast.h"
#include "app/people/crowd/character_look.h"
#include "app/people/crowd/crowd_looks.h"
#include "app/people/crowd/followers.h"
#include "app/people/crowd/layout.h"
#include "app/people/crowd/minds.h"
#include "app/people/crowd/parade.h"
#include "app/people/crowd/stadium.h"
#include "app/people/crowd/walkers.h"
#include "app/settings/settings.h"
#include "engine/base/gathered.h"

namespace throng::app {

/// Returns how much a tuning lets agents differ.
inline Variety variety_of(const Tuning& tuning) {
  return {tuning.variety, tuning.tint, tuning.size_variety, tuning.clothes, tuning.wardrobe};
}

/// Everything in a crowd that changes as time passes.
struct CrowdState {
  Ticks now{};
  CrowdPlaces places;
  CrowdMinds minds;
  CrowdWalkers walkers;  ///< the first agents: they walk where they like
  Marchers marchers;     ///< the agents after them, in rank and file; all others stay
  Wave wave;
  std::optional<FollowedTracks> tracks;  ///< none in scenes without a file
};

/// Decides which agents stand, walk, march or sit where, and what each does. All of it follows from scene, agents,
/// seed, the characters' roles and the frames' lengths; no pose is read. Spans have one element an agent, hold the
/// state after the last `advance`, and live as long as the crowd.
class Crowd {
 public:
  /// Makes a crowd of 1 to 256 `characters`. CrowdCast gives each agent one of them. `variety` says how much agents of
  /// one character differ; the first of a painted one is as its file has it. The scene `tracks` needs `tracks`,
  /// and an agent for each of its people; others do not read them.
  Crowd(Scene scene, std::size_t agents, std::uint32_t seed, std::span<const CharacterRoles> characters,
        const Variety& variety = {}, const TrackSource& tracks = {});
  Crowd(Scene scene, std::size_t agents, std::uint32_t seed, const CharacterRoles& character)
      : Crowd(scene, agents, seed, std::span(&character, 1)) {}
  Crowd(const Crowd&) = delete;  // its parts point at the cast
  Crowd& operator=(const Crowd&) = delete;

  /// Moves all agents by `dt` and returns the changes of clips, which are valid until the next call. Allocates nothing.
  /// `jobs`, 1 or more, run at once on `executor`; the result does not depend on either.
  std::span<const ClipRequest> advance(Ticks dt, Executor& executor, int jobs);
  /// Does the same in the calling thread.
  std::span<const ClipRequest> advance(Ticks dt);

  /// Takes other roles of the same characters, as large as before, each of which can walk as before. All agents keep
  /// place and heading. Returns the changes of clips, which are valid until the next call; moments of before are of
  /// another crowd.
  std::span<const ClipRequest> take_roles(std::span<const CharacterRoles> characters);

  /// Moves an agent that acts.
  void put(std::uint32_t agent, const glm::vec3& position, const Heading& heading);

  /// Keeps an agent where it is, in the way of all others, and lets it do nothing. Returns the request to stop walking,
  /// if it walks.
  std::optional<ClipRequest> hold(std::uint32_t agent);
  /// Lets an agent go on that was held. A marcher catches up with its place in the file.
  std::optional<ClipRequest> release(std::uint32_t agent);

  /// Takes people who follow tracks to another time, at a frame boundary.
  void go_to(const TrackClock& clock);
  /// Takes the rows that came of a live crowd. Call it before advance(), which moves all agents. `jobs` run at once.
  void take(const LiveStep& step, Executor& executor, int jobs);

  /// Returns all that changes, to be kept and put back.
  const CrowdState& state() const { return state_; }
  /// Puts a copy back; the crowd goes on as it did then, to the bit. The moment must be of this crowd.
  void go_back_to(const CrowdState& moment);

  /// Returns the roles that the scene was laid out for: common_roles() of the characters as they were then.
  const CharacterRoles& laid_out_for() const { return laid_out_for_; }
  const CrowdCast& cast() const { return cast_; }
  /// Returns how agents look; the code that dresses them changes it.
  CrowdLooks& looks() { return looks_; }
  const CrowdLooks& looks() const { return looks_; }
  /// Returns what agents have in mind and do; the code that puts things into their hands changes it.
  CrowdMinds& minds() { return state_.minds; }
  const CrowdMinds& minds() const { return state_.minds; }
  const CrowdWalkers& walkers() const { return state_.walkers; }
  const Marchers& marchers() const { return state_.marchers; }
  /// Returns the recorded crowd that agents follow; null in scenes without a file.
  const FollowedTracks* tracks() const { return state_.tracks ? &*state_.tracks : nullptr; }

  std::size_t size() const { return state_.places.positions.size(); }
  std::span<const glm::vec3> positions() const { return state_.places.positions; }  ///< metres, between the feet
  std::span<const Heading> headings() const { return state_.places.headings; }
  std::span<const float> speeds() const { return state_.places.speeds; }  ///< metres a second over the ground
  /// Returns the speeds at which the shown clips play. A gait plays at 0.4 to 1.7, so that feet do not slide; other
  /// clips play at 0.9 to 1.1. They change from frame to frame.
  std::span<const float> playback_speeds() const { return state_.places.playback_speeds; }
  std::span<const float> scales() const { return looks_.scales; }               ///< 0.7 to 1.3
  std::span<const std::uint8_t> characters() const { return cast_.numbers(); }  ///< index among the characters

 private:
  Crowd(const CrowdLayout& layout, Scene scene, std::uint32_t seed, std::span<const CharacterRoles> characters,
        const Variety& variety, const TrackSource& tracks, CharacterRoles common);
  void place(const CrowdLayout& layout);
  std::size_t first_stander() const { return walkers().count() + marchers().count(); }
  void follow_walkers(Executor& executor, int jobs);
  void follow_tracks(Executor& executor, int jobs);
  void march(Ticks dt);
  void decide(Executor& executor, int jobs);
  void turn_stander(std::size_t agent, Ticks dt);
  void match_playback(std::size_t agent);

  CharacterRoles laid_out_for_;
  CrowdCast cast_;
  CrowdLooks looks_;
  CrowdState state_;
  Gathered<std::uint32_t> due_;  // agents that go over to another role in this frame
};

/// Returns the middle of a box around all agents, as tall as they stand.
glm::vec3 middle_of(const Crowd& crowd);

/// Returns where the agents of a crowd stand.
inline PlacedAgents placed_agents(const Crowd& crowd) {
  return {.positions = crowd.positions(),
          .headings = crowd.headings(),
          .scales = crowd.scales(),
          .characters = crowd.characters()};
}

/// Returns [agent] 1 for agents that are not there now; empty where all are.
inline std::span<const std::uint8_t> absent_of(const Crowd& crowd) {
  return crowd.tracks() != nullptr ? crowd.tracks()->absent() : std::span<const std::uint8_t>();
}

/// Returns whether the body of an agent is that of a child.
bool is_child(const Crowd& crowd, std::size_t agent);

}  // namespace throng::app
