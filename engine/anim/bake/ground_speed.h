#pragma once

#include <glm/vec2.hpp>

#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/bake/stride.h"

namespace throng::anim {

/// Metres a second, x and z, at which the lowest moving joint, which bears the weight, moves over the ground in a
/// looping clip that stays in place: the median over the clip, or 0 if it is small or if the joints do not agree on one
/// (idle, gestures).
glm::dvec2 stance_velocity(const Stride& stride);

/// How fast that is.
double stance_speed(const Skeleton& skeleton, const KeyframeStream& stream, double height);

}  // namespace throng::anim
