#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "app/people/crowd/stride_plane.h"
#include "engine/anim/asset/marker_map.h"
#include "engine/anim/bake/character.h"

namespace throng::app {

inline constexpr std::size_t person_legs = 2;  ///< left, then right, as anim::CharacterRigs has them

/// Tells when the feet of each gait of a character stand, measured on the clips at load: a foot stands while its ball
/// is low and goes back as fast as the gait goes ahead. It tells too where each gait is while another counts steps.
class Stances {
 public:
  Stances() = default;
  Stances(const anim::Character& character, const StridePlane& plane);

  /// Returns how far inside of its stance a foot is at a place of a gait's clip, 0 to 1: above 1 it stands, below 0 it
  /// is in the air. Margins and the stance of several gaits are mixed like the gaits. `point` is a gait of the
  /// plane. A foot whose clip has no stance is reported to stand half the time.
  float margin(std::size_t point, std::size_t leg, double phase) const;

  /// Maps the clip by whose stride cycles are counted (StridePlane::reference) to the clip of a point of the plane.
  const anim::MarkerMap& in_step(std::size_t point) const { return in_step_[point]; }

 private:
  /// The part of a clip in which a foot stands.
  struct Stance {
    float down = 0.0F;    // phase, 0 to below 1
    float length = 0.5F;  // of the cycle
  };
  std::vector<std::array<Stance, person_legs>> of_;  // [point]
  std::vector<anim::MarkerMap> in_step_;             // [point]
};

}  // namespace throng::app
