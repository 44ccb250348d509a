#pragma once

#include <glm/vec3.hpp>

#include "engine/anim/asset/keyframe_stream_clip.h"

namespace throng::anim {

/// Ground-plane travel of the topmost bone that moves and carries most of the skeleton, from the clip's start to its
/// end, in model space; 0 where it is at most `least` metres, or cannot be taken out because a root moves in steps.
glm::dvec3 find_root_motion(const Skeleton& skeleton, const StateClip& clip, double least);

/// Takes `travel` * time / duration out of the model-space pose: out of every root bone, so that all that the skeleton
/// holds comes along.
void take_root_motion(const Skeleton& skeleton, StateClip& clip, const glm::dvec3& travel);

/// What of `travel` one root bone's state position takes.
glm::dvec3 drift_of_root(const Skeleton& skeleton, int bone, const glm::dvec3& travel);

}  // namespace throng::anim
