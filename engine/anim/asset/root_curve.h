#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/base/units.h"

namespace throng::anim {

/// A rigid motion over the ground: turn by `yaw` about +Y (from +Z towards +X), then move.
struct RootMotion {
  glm::dvec3 translation{0.0};  ///< metres; y is 0
  double yaw = 0.0;             ///< radians, not wrapped: two turns are 4 pi
};

/// `first`, then `second` as seen from where `first` leads.
RootMotion compose(const RootMotion& first, const RootMotion& second);
RootMotion inverse(const RootMotion& motion);
/// `motion` `times` over, negative: its inverse; a closed form, whatever the number.
RootMotion power(const RootMotion& motion, double times);

/// Where the root has come to since the clip's start, in model space.
struct RootKey {
  Ticks time = 0;
  double x = 0.0;  ///< metres
  double z = 0.0;
  double yaw = 0.0;  ///< radians, not wrapped
};

/// The motion that baking took out of a clip's pose, as straight lines between keys.
struct RootCurve {
  Ticks duration = 0;
  std::vector<RootKey>
      keys;  ///< by time, strictly; the first is at 0 and all zero, the last at `duration`; or empty: none
};

/// Straight ahead at an even speed: `translation` from the start to the end. Empty where it is 0.
RootCurve straight_root_curve(Ticks duration, const glm::dvec3& translation);

/// How a character that plays from one position to another moves, seen from where it stands at first: whole loops times
/// the loop's transform, and the curve in between, in double. Positions are unwrapped as for for_each_data_key: of a
/// clip that does not loop they are held at its ends. Motions of adjoining intervals compose to that of the whole.
RootMotion displacement(const RootCurve& curve, FineTicks from, FineTicks to, bool looping);

/// The rate of the displacement at a clip's own position, 0 to its duration, in the character's own space. At a key it
/// is that of what follows, at the end that of what came before.
struct RootVelocity {
  glm::dvec3 linear{0.0};  ///< metres a second of the clip
  double yaw = 0.0;        ///< radians a second of the clip
};
RootVelocity root_velocity(const RootCurve& curve, FineTicks position);

}  // namespace throng::anim
