#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "app/character/roles.h"
#include "app/crowd/cast.h"
#include "app/crowd/character_look.h"
#include "app/crowd/crowd_looks.h"
#include "app/crowd/followers.h"
#include "app/crowd/layout.h"
#include "app/crowd/minds.h"
#include "app/crowd/steering/gathered.h"
#include "app/crowd/walkers.h"
#include "app/live/live_crowd.h"
#include "app/settings/settings.h"
#include "app/trajectory/track_clock.h"
#include "engine/anim/base/executor.h"
#include "engine/anim/base/units.h"

namespace throng::app {

/// Returns how much a tuning lets agents differ.
inline Variety variety_of(const Tuning& tuning) {
  return {tuning.variety, tuning.tint, tuning.size_variety, tuning.clothes, tuning.wardrobe};
}

/// Everything in a crowd that changes as time passes.
struct CrowdState {
  anim::Ticks now{};
  std::vector<anim::Ticks> behind;      ///< [marcher] how late it is at its places
  std::vector<anim::Ticks> next_waves;  ///< [stander] when the wave is there; empty: there is no wave
  CrowdMinds minds;
  CrowdWalkers walkers;
  std::vector<glm::vec3> positions;
  std::vector<Heading> headings;
  std::vector<float> speeds, playback_speeds;
  TrackClock track_clock;            ///< of followers
  std::vector<std::uint8_t> absent;  ///< [agent] 1: it is not there; empty: everybody is
};
using CrowdMoment = std::optional<CrowdState>;

/// Decides who stands, walks, marches or sits where, and what each of them does. All of it follows from scene, agents,
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

  /// Moves everyone by `dt` and returns the changes of clips, which are valid until the next call. Allocates nothing.
  /// `jobs`, 1 or more, run at once on `executor`; the result does not depend on either.
  std::span<const ClipRequest> advance(anim::Ticks dt, anim::Executor& executor, int jobs);
  /// Does the same in the calling thread.
  std::span<const ClipRequest> advance(anim::Ticks dt);

  /// Takes other roles of the same characters, as large as before, each of which can walk as before. Everybody keeps
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
  bool holds(std::uint32_t agent) const { return state_.minds.holds(agent); }

  /// Copies all that changes.
  void remember(CrowdMoment& into) const { into = state_; }
  /// Puts a copy back; the crowd goes on as it did then, to the bit. The moment must be of this crowd.
  void go_back_to(const CrowdMoment& moment);

  /// Returns the roles that the scene was laid out for: common_roles() of the characters as they were then.
  const CharacterRoles& laid_out_for() const { return laid_out_for_; }

  std::size_t size() const { return state_.positions.size(); }
  std::span<const glm::vec3> positions() const { return state_.positions; }  ///< metres, between the feet
  std::span<const Heading> headings() const { return state_.headings; }
  std::span<const float> scales() const { return looks_.scales; }  ///< 0.7 to 1.3
  std::span<const float> radii() const { return looks_.radii; }    ///< metres, of the body seen from above
  std::span<const float> speeds() const { return state_.speeds; }  ///< metres a second over the ground
  /// Returns the speeds at which the shown clips play. A gait plays at 0.4 to 1.7, so that feet do not slide; other
  /// clips play at 0.9 to 1.1. They change from frame to frame.
  std::span<const float> playback_speeds() const { return state_.playback_speeds; }
  std::span<const float> start_phases() const { return looks_.start_phases; }   ///< 0 to below 1, of the first clip
  std::span<const std::uint8_t> characters() const { return cast_.numbers(); }  ///< index among the characters
  std::span<const Tints> tints() const { return looks_.tints; }
  /// Returns what drawing reads of everybody's looks.
  const CrowdLooks& looks() const { return looks_; }
  std::span<const Role> roles() const { return state_.minds.roles(); }
  std::span<const Habit> habits() const { return state_.minds.habits(); }
  std::span<const int> clips() const {
    return state_.minds.clips();
  }  ///< index, or no_clip for a character that has none

  std::span<const Lane> lanes() const { return state_.walkers.lanes(); }
  std::size_t walkers() const { return state_.walkers.count(); }  ///< the first agents: they walk where they like
  std::size_t marchers() const { return marchers_.size(); }       ///< those after them: rank and file; all others stay

 private:
  friend glm::vec3 middle_of(const Crowd& crowd);
  friend const Followers* followers_of(const Crowd& crowd);
  friend void give(Crowd& crowd, std::vector<Held> things) { crowd.state_.minds.give(std::move(things)); }
  friend std::span<const Held> things_of(const Crowd& crowd) { return crowd.state_.minds.things(); }
  friend const TrackClock& track_clock_of(const Crowd& crowd);
  friend void set_track_clock(Crowd& crowd, const TrackClock& clock);
  friend void take_live_step(Crowd& crowd, const LiveStep& step, anim::Executor& executor, int jobs);
  friend std::span<const std::uint8_t> absent_of(const Crowd& crowd);
  friend bool is_child(const Crowd& crowd, std::size_t agent);
  friend std::uint32_t company_of(const Crowd& crowd, std::size_t marcher) { return crowd.marchers_[marcher].company; }
  friend void wear(Crowd& crowd, std::vector<render::AgentLook> looks, std::vector<render::Outfit> outfits,
                   std::vector<std::uint16_t> in_hand);
  Crowd(const CrowdLayout& layout, Scene scene, std::uint32_t seed, std::span<const CharacterRoles> characters,
        const Variety& variety, const TrackSource& tracks, CharacterRoles common);
  void place(const CrowdLayout& layout);
  void expect_wave(const CrowdLayout& layout);
  void lead_wave();
  void follow_walkers(anim::Executor& executor, int jobs);
  void march(anim::Ticks dt);
  void march_at(double speed);
  void decide(anim::Executor& executor, int jobs);
  void turn_standers(anim::Ticks dt, anim::Executor& executor, int jobs);
  void turn_stander(std::size_t agent, anim::Ticks dt);
  double marching_time(std::size_t marcher, anim::Ticks dt);
  void match_playback(std::size_t agent);
  void follow(const TrackSource& tracks, std::uint32_t seed);
  void follow_tracks(anim::Executor& executor, int jobs);
  void follow_track(std::size_t agent);

  CharacterRoles laid_out_for_;
  CrowdCast cast_;
  Lane route_;
  std::vector<MarcherStart> marchers_;
  CrowdLooks looks_;
  CrowdState state_;
  Gathered<std::uint32_t> due_;  // agents that go over to another role in this frame
  anim::Ticks wave_period_{};
  std::optional<Followers> followers_;
};

/// Returns the middle of a box around all agents, as tall as they stand.
glm::vec3 middle_of(const Crowd& crowd);

/// Returns the number of the company in which somebody marches, counted from 0 at the head of a parade.
std::uint32_t company_of(const Crowd& crowd, std::size_t marcher);

/// Puts things into everybody's hands, [agent]; empty: nothing. It decides what they do from then on.
void give(Crowd& crowd, std::vector<Held> things);
/// Returns [agent] what everybody holds; empty: nothing.
std::span<const Held> things_of(const Crowd& crowd);

/// Returns the people of a recorded crowd; null in the other scenes.
inline const Followers* followers_of(const Crowd& crowd) { return crowd.followers_ ? &*crowd.followers_ : nullptr; }
/// Returns the time of the recorded crowd.
inline const TrackClock& track_clock_of(const Crowd& crowd) { return crowd.state_.track_clock; }
/// Takes a recorded crowd to another time, at a frame boundary.
void set_track_clock(Crowd& crowd, const TrackClock& clock);
/// Takes the rows that came of a live crowd. Call it before advance(), which moves everybody. `jobs` run at once.
void take_live_step(Crowd& crowd, const LiveStep& step, anim::Executor& executor, int jobs);
/// Returns whether the body of an agent is that of a child.
bool is_child(const Crowd& crowd, std::size_t agent);
/// Dresses everybody: how they look, and the pieces of their character's mesh that they wear.
void wear(Crowd& crowd, std::vector<render::AgentLook> looks, std::vector<render::Outfit> outfits,
          std::vector<std::uint16_t> in_hand = {});
/// Returns [agent] 1 for people who are not there now; empty where everybody is.
inline std::span<const std::uint8_t> absent_of(const Crowd& crowd) { return crowd.state_.absent; }

}  // namespace throng::app
