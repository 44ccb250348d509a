#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/base/units.h"

namespace throng::anim {

/// A rigid motion over the ground: it turns by `yaw` about +Y (from +Z towards +X), then moves.
struct RootMotion {
  glm::dvec3 translation{0.0};  ///< metres; y is 0
  double yaw = 0.0;             ///< radians, not wrapped: two turns are 4 pi
};

/// Does `first`, then `second` as seen from where `first` leads.
RootMotion compose(const RootMotion& first, const RootMotion& second);
RootMotion inverse(const RootMotion& motion);
/// Repeats `motion` `times` times; a negative number repeats its inverse. Every number costs the same.
RootMotion power(const RootMotion& motion, double times);

/// The place and direction that the root has reached since the clip's start, in model space.
struct RootKey {
  Ticks time{};
  double x = 0.0;  ///< metres
  double z = 0.0;
  double yaw = 0.0;  ///< radians, not wrapped
};

/// The motion that baking takes out of a clip's pose, as straight lines between keys.
struct RootCurve {
  Ticks duration{};
  std::vector<RootKey> keys;  ///< ascending; the first is all zero, the last at `duration`; empty: no motion
};

/// Makes a curve that leads straight along `translation` at an even speed; without keys where `translation` is 0.
RootCurve straight_root_curve(Ticks duration, const glm::dvec3& translation);

/// Returns how a character moves while it plays from one position to another, seen from where it stands first: the
/// loop's motion times the whole loops, and the curve in between, in double. Positions are unwrapped, as in
/// for_each_data_key; those of a clip that does not loop are held at its ends. The motions of adjoining intervals
/// compose to the motion of the whole.
RootMotion displacement(const RootCurve& curve, FineTicks from, FineTicks to, bool looping);

/// The rate of the displacement at a position from 0 to the clip's duration, in the character's own space. At a key it
/// is the rate after the key, at the end the rate before the end.
struct RootVelocity {
  glm::dvec3 linear{0.0};  ///< metres a second of the clip
  double yaw = 0.0;        ///< radians a second of the clip
};
RootVelocity root_velocity(const RootCurve& curve, FineTicks position);

}  // namespace throng::anim
