#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "throng/host.h"

#include "app/people/crowd/cast.h"
#include "app/people/crowd/layout.h"
#include "app/people/crowd/minds.h"
#include "app/people/crowd/stride_plane.h"
#include "app/people/crowd/talks.h"
#include "app/people/crowd/track_steps.h"
#include "engine/tracks/ground_bounds.h"
#include "engine/tracks/live/live_crowd.h"
#include "engine/tracks/presence.h"
#include "engine/tracks/track_clock.h"
#include "engine/tracks/trajectories.h"

namespace throng::app {

/// A recorded crowd, and how each of the characters that play it moves.
struct TrackSource {
  std::shared_ptr<const Trajectories> trajectories;
  std::vector<StridePlane> planes;  ///< [character]
};

/// The people of a recorded crowd. Agent i is person i of the file. Everything about a person is a function of time, so
/// a clock may go to any moment. Only people whose rows still come change once they are made.
class Followers {
 public:
  /// `characters` and `scales` have one element an agent. A person without rows is not there.
  Followers(TrackSource source, std::span<const std::uint8_t> characters, std::span<const float> scales,
            std::uint32_t seed);

  std::size_t count() const { return steps_.size(); }
  const Trajectories& trajectories() const { return *source_.trajectories; }
  const std::shared_ptr<const Trajectories>& file() const { return source_.trajectories; }
  /// Returns the bounds that hold all people at every time.
  const GroundBounds& bounds() const { return bounds_; }
  const StridePlane& plane(std::size_t agent) const { return plane_of_character(characters_[agent]); }
  const StridePlane& plane_of_character(std::size_t character) const { return source_.planes[character]; }

  const Presence& presence(std::size_t agent) const { return presences_[agent]; }
  bool is_there(std::size_t agent, double seconds) const { return presence(agent).has(seconds); }
  glm::vec3 position(std::size_t agent, double seconds) const { return tracks_[agent].position(seconds); }
  const SmoothTrack& way(std::size_t agent) const { return tracks_[agent]; }
  TrackStep step(std::size_t agent, double seconds) const { return steps_[agent].at(seconds); }
  /// Returns the talk of a person. While rows still come, no person talks, for nothing tells yet who will stay.
  TalkMoment talk(std::size_t agent, double seconds) const { return talks_.at(agent, seconds); }

  /// Takes what all people have in common whose rows come. Call it before renew() for each of them.
  void begin_renewing(std::span<const std::uint32_t> agents);
  /// Takes the rows of a person as they are now: more than before, or another person's. Moments up to `settled` stay.
  /// `height` is the character's. Returns the person's scale. Several threads may do it for different people.
  float renew(std::size_t agent, float height, double settled);

 private:
  TrackSource source_;
  std::vector<std::uint8_t> characters_;
  std::vector<float> scales_, first_headings_;  // [agent] before the file's own
  std::vector<Presence> presences_;             // [agent]
  std::vector<SmoothTrack> tracks_;             // [agent]
  std::vector<TrackSteps> steps_;               // [agent]
  Talks talks_;
  GroundBounds bounds_;
};

/// The tracks of a recorded crowd that agents follow, at the time of a clock. Copies share the people.
class FollowedTracks {
 public:
  /// `scales` has one element an agent; agents whose height the file tells take theirs from it.
  FollowedTracks(const TrackSource& source, const CrowdCast& cast, std::span<float> scales, std::uint32_t seed);

  const Followers& people() const { return *people_; }
  const TrackClock& clock() const { return clock_; }
  /// Returns [agent] 1 for people who are not there now.
  std::span<const std::uint8_t> absent() const { return absent_; }

  void set_clock(const TrackClock& clock) { clock_ = clock; }
  void advance(Ticks dt) { throng::advance(clock_, to_seconds(dt)); }
  /// Takes the rows that came of a live crowd, and the scales of the people that they change. `jobs` run at once.
  void take(const LiveStep& step, const CrowdCast& cast, std::span<float> scales, Executor& executor, int jobs);
  /// Puts agents where their people are now; an agent that is not there keeps its place. `jobs` run at once.
  void place(const CrowdCast& cast, std::span<const float> scales, CrowdPlaces& places, CrowdMinds& minds,
             Executor& executor, int jobs);

 private:
  std::shared_ptr<Followers> people_;
  TrackClock clock_;
  std::vector<std::uint8_t> absent_;
};

}  // namespace throng::app
