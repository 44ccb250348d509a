#pragma once

#include "engine/anim/base/pose.h"

namespace throng::anim {

/// Inertialisation: at a change of source the new one is taken at once. Its offset to the pose shown last is added
/// and decays. Only one source is evaluated, however often the change is interrupted.
///
/// The offset of a bone is the rotation `shown * target^-1` as a rotation vector, and the difference of the positions.
/// The rotation is on the left of the target's, so it is fixed in the parent's frame. It commutes with the
/// bind-relative form of rotations (pose.h), which only turns the vector's axes. Scale is not inertialised.
///
///     offset     = rotation vector x y z, rad     position x y z, m         float, [6][16]
///     velocity   = its rate, rad/s                its rate, m/s             float, [6][16]
inline constexpr int offset_components = 6;

/// The lengths to which a velocity is cut, a vector at a time, so that a jump in what was shown is no throw. They are
/// as fast as joints turn in a sprint and bodies fall in half a second.
inline constexpr float fastest_offset_turn = 20.0F;  ///< rad/s
inline constexpr float fastest_offset_move = 5.0F;   ///< m/s

/// Capture: takes the offset of 16 bones, once at the change. The velocity is that of the offset from one update to the
/// next: shown against target now, less shown_before against target_before, over the time between. Rotations take the
/// shorter arc.
struct OffsetCaptureJob {
  const float* shown = nullptr;          ///< [components][16], the pose shown last
  const float* shown_before = nullptr;   ///< [components][16], shown one update earlier; null: velocities are 0
  const float* target = nullptr;         ///< [components][16], the new source at the time of `shown`
  const float* target_before = nullptr;  ///< [components][16], one update earlier; null: the target rests
  float seconds_between = 0.0F;          ///< length of the update between; velocities are 0 unless it is positive
  float* offsets = nullptr;              ///< out, [6][16], apart from all inputs
  float* velocities = nullptr;           ///< out, [6][16], apart from all inputs
};
bool is_valid(const OffsetCaptureJob& job);

/// The parts that are left of an offset and, in seconds, of its velocity. Both are 0 when the offset has ended.
struct OffsetDecay {
  float offset = 0.0F;    ///< (1 + y t) e^(-y t)
  float velocity = 0.0F;  ///< t e^(-y t)
};

/// The half-lives after which an offset ends, with less than 0.003 % of it left.
inline constexpr float offset_half_lives = 8.0F;

/// Returns the critically damped decay, `seconds` (>= 0) after the capture. An offset at rest is halved in `half_life`
/// seconds, and y is 1.678 / half_life. It is over at once if half_life is not positive. It has the same bits on every
/// machine.
OffsetDecay offset_decay(float seconds, float half_life);

/// Apply: makes out = target with offset * decay.offset + velocity * decay.velocity added, at every update until the
/// end. An offset x that moves at v stays within |x| + 0.22 |v| half_life, at most half a turn. An offset at rest only
/// shrinks. An offset that moves towards its target may pass it by 0.22 |v| half_life at most. A bone whose offset is
/// 0, and every bone when the decay has ended, has the target's bits. `out` may be `target`.
struct OffsetApplyJob {
  const float* target = nullptr;      ///< [components][16]
  const float* offsets = nullptr;     ///< [6][16]
  const float* velocities = nullptr;  ///< [6][16]
  OffsetDecay decay;
  int components = rigid_components;
  float* out = nullptr;  ///< [components][16]
};
bool is_valid(const OffsetApplyJob& job);

}  // namespace throng::anim
