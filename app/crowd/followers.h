#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "app/crowd/stride_plane.h"
#include "app/crowd/track_steps.h"
#include "app/trajectory/ground_bounds.h"
#include "app/trajectory/trajectories.h"

namespace throng::app {

/// A recorded crowd, and how each of the characters that play it moves.
struct TrackSource {
  std::shared_ptr<const Trajectories> trajectories;
  std::vector<StridePlane> planes;  ///< [character]
};

/// The people of a recorded crowd. Agent i is person i of the file. Everything about them is a function of time, so a
/// clock may go to any moment; nothing changes once they are made.
class Followers {
 public:
  /// `characters` and `scales` have one element an agent.
  Followers(TrackSource source, std::span<const std::uint8_t> characters, std::span<const float> scales,
            std::uint32_t seed);

  std::size_t count() const { return steps_.size(); }
  const Trajectories& trajectories() const { return *source_.trajectories; }
  const std::shared_ptr<const Trajectories>& file() const { return source_.trajectories; }
  /// Returns what holds everybody at every time.
  const GroundBounds& bounds() const { return bounds_; }
  const StridePlane& plane(std::size_t agent) const { return plane_of_character(characters_[agent]); }
  const StridePlane& plane_of_character(std::size_t character) const { return source_.planes[character]; }

  /// Returns whether somebody is there at a time: from the first row to the last one. Who has a single row is there as
  /// long as a row lasts.
  bool is_there(std::size_t agent, double seconds) const {
    const SmoothTrack& way = tracks_[agent];
    const double last = way.row_count() > 1 ? way.last() : way.first() + row_seconds_;
    return seconds >= way.first() && seconds <= last;
  }
  glm::vec3 position(std::size_t agent, double seconds) const { return tracks_[agent].position(seconds); }
  const SmoothTrack& way(std::size_t agent) const { return tracks_[agent]; }
  TrackStep step(std::size_t agent, double seconds) const { return steps_[agent].at(seconds); }

 private:
  TrackSource source_;
  std::vector<std::uint8_t> characters_;
  std::vector<SmoothTrack> tracks_;  // [agent]
  std::vector<TrackSteps> steps_;    // [agent]
  GroundBounds bounds_;
  double row_seconds_ = 0.0;
};

}  // namespace throng::app
