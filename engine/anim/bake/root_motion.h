#pragma once

#include <glm/vec3.hpp>

#include "engine/anim/asset/keyframe_stream_clip.h"

namespace throng::anim {

/// Returns how far the topmost moving bone that carries most of the skeleton travels over the ground, from the clip's
/// start to its end, in model space. 0 where that is at most `least` metres, or where a root moves in steps, from which
/// nothing can be taken out.
glm::dvec3 find_root_motion(const Skeleton& skeleton, const StateClip& clip, double least);

/// Takes `travel` * time / duration out of every root bone, so that the whole skeleton comes along.
void take_root_motion(const Skeleton& skeleton, StateClip& clip, const glm::dvec3& travel);

/// Converts `travel` to the space of a root bone's state position.
glm::dvec3 drift_of_root(const Skeleton& skeleton, int bone, const glm::dvec3& travel);

}  // namespace throng::anim
