#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "app/people/crowd/stride_plane.h"
#include "engine/tracks/smooth_track.h"

namespace throng::app {

/// A moment of a person's steps.
struct TrackStep {
  float heading = 0.0F;      ///< radians from +Z towards +X
  glm::vec2 velocity{0.0F};  ///< metres a second at scale 1, aside (to the left) and ahead, without sway
  double cycles = 0.0;       ///< strides so far, but for whole multiples of TrackSteps::cycles_in_all
};

/// Tells where a person looks and how many steps the person has made, all along a track. It is a function of time
/// alone, so any moment can be read without earlier ones. It keeps the values of every tenth of a second, or fifth
/// where rows are that far apart, so that a frame reads one place in memory; fewer where rows are minutes apart.
///
/// Without headings in the file, people turn to where they walk, the sooner the faster they are. A person who hardly
/// moves hardly turns, and steps back or aside where the file goes there. A person who stands keeps the heading.
class TrackSteps {
 public:
  static constexpr float cycles_in_all = 256.0F;
  static constexpr double stride_window = 0.8;  ///< seconds, about a stride: their mean velocity has no sway

  TrackSteps() = default;
  /// `scale`: of the body. `first_heading`: of a person who never moves.
  TrackSteps(const SmoothTrack& track, const StridePlane& plane, float scale, float first_heading);

  /// Returns a moment; nothing but zeros where there is no track yet.
  TrackStep at(double seconds) const;

  /// Takes rows that were added to the end of the track, or another track that begins later than this one ends. Moments
  /// up to `settled` stay, except before the track's first row.
  void extend(const SmoothTrack& track, const StridePlane& plane, float scale, float first_heading, double settled);

 private:
  struct Knot {
    float heading = 0.0F;  // not wrapped, so that it can be interpolated
    float cycles = 0.0F;   // 0 to below cycles_in_all
    glm::vec2 velocity{0.0F};
  };
  void begin(const SmoothTrack& track);
  void end_with(const SmoothTrack& track);
  void turn(const SmoothTrack& track, float first_heading, std::size_t from);
  void walk(const SmoothTrack& track, const StridePlane& plane, float scale, std::size_t from);
  float heading_at_first(const SmoothTrack& track, float first_heading) const;
  double time_of(std::size_t knot) const { return first_ + spacing_ * static_cast<double>(knot); }

  std::vector<Knot> knots_;
  double first_ = 0.0, spacing_ = 0.1;
};

}  // namespace throng::app
