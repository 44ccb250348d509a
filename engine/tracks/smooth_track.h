#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engine/tracks/trajectories.h"

namespace throng {

/// A person's way as a curve: it goes through every row, and nowhere between two rows farther aside than half of their
/// distance. The rows, at least one, outlive it. Before the first row and after the last one it stands still.
///
/// Between two rows it is a cubic in Hermite's form. The velocity at a row is the velocity of the parabola through it
/// and its neighbours (E. Catmull and R. Rom, "A class of local interpolating splines", 1974, for rows at any
/// distance), at an end of the parabola which ends there. It is at most a few times the slower side's, so that a person
/// who stops does not go beyond and come back.
class SmoothTrack {
 public:
  /// Makes an empty track, which ends before it begins. It has no place, velocity or heading.
  SmoothTrack() = default;
  explicit SmoothTrack(std::span<const TrackRow> rows)
      : rows_(rows), first_(rows.front().seconds), last_(rows.back().seconds) {}

  std::size_t row_count() const { return rows_.size(); }
  double first() const { return first_; }
  double last() const { return last_; }

  /// Returns metres at a time of the file's clock.
  glm::vec3 position(double seconds) const;
  /// Returns the mean velocity of `window` seconds around a time, or of the part of them that is known: x and z,
  /// metres a second. A window as long as a stride takes the sway of a recorded head out.
  glm::vec2 velocity(double seconds, double window) const;
  /// Returns whether the file says where this person looks.
  bool has_heading() const { return rows_.front().heading == rows_.front().heading; }
  /// Returns the file's heading at a time, radians from +Z towards +X, by the shorter way between two rows.
  float heading(double seconds) const;

 private:
  std::size_t row_before(double seconds) const;
  glm::vec2 slope(std::size_t row) const;

  std::span<const TrackRow> rows_;
  double first_ = std::numeric_limits<double>::infinity(),
         last_ = -first_;  // of the rows, which lie far apart in memory
};

/// Returns an angle, in radians, from -pi to pi.
float wrapped_angle(float angle);

}  // namespace throng
