#pragma once

#include <glm/vec2.hpp>

#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/root_curve.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/bake/stride.h"

namespace throng::anim {

/// Returns the velocity over the ground, in metres a second along x and z, of the lowest moving joint, which bears the
/// weight. The clip loops and stays in place. The velocity is the median over the clip, or 0 if it is small or if the
/// samples do not agree (idle, gestures).
glm::dvec2 stance_velocity(const Stride& stride);

/// Returns the length of that velocity.
double stance_speed(const Skeleton& skeleton, const KeyframeStream& stream, double height);

/// Returns the speed over the ground, in metres a second, of a clip that travels: along the arc if it turns. It is 0
/// for a body that turns on the spot.
double travel_speed(const RootCurve& curve);

}  // namespace throng::anim
