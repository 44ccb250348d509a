#pragma once

#include <vector>

#include <glm/vec4.hpp>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

/// A key in state space; positions and scales leave w at 0. Tangents are per second, CUBICSPLINE only.
struct StateKey {
  Ticks time = 0;
  glm::dvec4 value{0.0};
  glm::dvec4 in_tangent{0.0};
  glm::dvec4 out_tangent{0.0};
};

/// A track that moves: two keys or more.
struct StateTrack {
  int bone = 0;
  KeyChannel channel = KeyChannel::rotation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<StateKey> keys;  ///< by time
};

/// A clip as animation states see it (ReferenceFrame), in double. The conversion of a track is linear or affine, so
/// interpolating after it is interpolating before it.
struct StateClip {
  Ticks duration = 0;
  int components = rigid_components;
  std::vector<StateTransform> constants;  ///< one a bone: what holds where nothing moves; rotations unit
  std::vector<StateTrack> tracks;         ///< by bone, then channel
};

StateClip to_state_space(const Skeleton& skeleton, const Clip& clip);

/// Seconds: a day. Players count in parts of ticks, and a file may claim any time; later keys are held there.
inline constexpr double longest_clip = 86'400.0;

/// Ticks of a key time of a file.
Ticks key_ticks(double seconds);

/// Subtracts `drift` * time / duration from the position of `bone`, exactly: whatever its track was, the difference is
/// linear in time. Its position track must not be a moving STEP track; the clip lasts longer than 0.
void subtract_drift(StateClip& clip, int bone, const glm::dvec3& drift);

AlignedBytes pack_keyframe_stream(const StateClip& clip);

}  // namespace throng::anim
