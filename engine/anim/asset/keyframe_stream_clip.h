#pragma once

#include <vector>

#include <glm/vec4.hpp>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

/// A key in state space. Positions and scales leave w at 0. Tangents are per second and belong to CUBICSPLINE only.
struct StateKey {
  Ticks time{};
  glm::dvec4 value{0.0};
  glm::dvec4 in_tangent{0.0};
  glm::dvec4 out_tangent{0.0};
};

/// A moving track, with two keys or more.
struct StateTrack {
  int bone = 0;
  KeyChannel channel = KeyChannel::rotation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<StateKey> keys;  ///< by time
};

/// A clip in the space of animation states (see ReferenceFrame), in double. A track is converted by a linear or affine
/// map, so it makes no difference whether values are interpolated before or after.
struct StateClip {
  double start = 0.0;  ///< seconds, the file's time at time 0
  Ticks duration{};
  int components = rigid_components;
  std::vector<StateTransform> constants;  ///< one a bone: the values that hold where nothing moves; rotations unit
  std::vector<StateTrack> tracks;         ///< by bone, then channel
};

/// Time 0 of the result is `start` seconds of the file, at most the clip's first key.
StateClip to_state_space(const Skeleton& skeleton, const Clip& clip, double start = 0.0);

/// A day in seconds. Players count parts of ticks, and a file may claim any time; later keys are moved back to it.
inline constexpr double longest_clip = 86'400.0;

/// Converts a key time of a file to ticks.
Ticks key_ticks(double seconds);

/// Subtracts `drift` * time / duration from the position of `bone`. This is exact for every interpolation, because the
/// difference is linear in time. The bone has no moving STEP track of its position; the clip lasts longer than 0.
void subtract_drift(StateClip& clip, int bone, const glm::dvec3& drift);

AlignedBytes pack_keyframe_stream(const StateClip& clip);

}  // namespace throng::anim
