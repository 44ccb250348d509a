#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/base/units.h"

namespace throng::anim {

/// A rigid motion of an upright body: it turns by `yaw` about +Y (from +Z towards +X), then moves. It may climb.
struct RootMotion {
  glm::dvec3 translation{0.0};  ///< metres
  double yaw = 0.0;             ///< radians, not wrapped: two turns are 4 pi
};

/// Does `first`, then `second` as seen from where `first` leads.
RootMotion compose(const RootMotion& first, const RootMotion& second);
RootMotion inverse(const RootMotion& motion);
/// Repeats `motion` `times` times; a negative number repeats its inverse. Every number costs the same. A part of a
/// motion that turns by less than half a turn leads along its arc.
RootMotion power(const RootMotion& motion, double times);

/// A steady motion in the character's own space: along a straight line or an arc.
struct RootVelocity {
  glm::dvec3 linear{0.0};  ///< metres a second
  double yaw = 0.0;        ///< radians a second
};
/// Returns where a steady motion leads in `seconds`.
RootMotion moved_by(const RootVelocity& velocity, double seconds);
/// Returns the steady motion that leads to `motion` in `seconds`. It turns by less than a whole turn.
RootVelocity steady_velocity(const RootMotion& motion, double seconds);

/// The place and direction that the root has reached since the clip's start, in model space.
struct RootKey {
  Ticks time{};
  double x = 0.0;  ///< metres
  double y = 0.0;
  double z = 0.0;
  double yaw = 0.0;  ///< radians, not wrapped
};

/// The motion that baking takes out of a clip's pose. It is steady between keys: a straight line, or an arc where the
/// root turns, by less than a whole turn.
struct RootCurve {
  Ticks duration{};
  std::vector<RootKey> keys;  ///< ascending; the first is all zero, the last at `duration`; empty: no motion
};

/// Makes a curve that leads straight along `translation` at an even speed; without keys where `translation` is 0.
RootCurve straight_root_curve(Ticks duration, const glm::dvec3& translation);
/// Makes the curve of a steady motion. `duration` is above 0.
RootCurve steady_root_curve(Ticks duration, const RootVelocity& velocity);

/// Returns the motion of the whole curve; none without keys.
RootMotion whole_motion(const RootCurve& curve);
/// Says whether its root turns on the way.
inline bool turns(const RootCurve& curve) { return !curve.keys.empty() && curve.keys.back().yaw != 0.0; }

/// Returns how a character moves while it plays from one position to another, seen from where it stands first: the
/// loop's motion times the whole loops, and the curve in between, in double. Positions are unwrapped, as in
/// for_each_data_key; positions in a clip that does not loop are held at its ends. The motions of adjoining intervals
/// compose to the motion of the whole.
RootMotion displacement(const RootCurve& curve, FineTicks from, FineTicks to, bool looping);

/// Returns the rate of the displacement at a position from 0 to the clip's duration, a second of the clip. At a key it
/// is the rate after the key, at the end the rate before the end.
RootVelocity root_velocity(const RootCurve& curve, FineTicks position);

}  // namespace throng::anim
