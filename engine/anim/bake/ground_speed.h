#pragma once

#include <glm/vec2.hpp>

#include "engine/anim/asset/root_curve.h"
#include "engine/anim/bake/stride.h"

namespace throng::anim {

/// Returns the velocity over the ground, in metres a second along x and z, of the lowest moving joint, which bears the
/// weight. The clip loops and stays in place. The velocity is the median over the clip, or 0 if it is small or if the
/// samples do not agree (idle, gestures).
glm::dvec2 stance_velocity(const Stride& stride);

/// Returns the velocity over the ground at the start of a clip that travels, in metres a second along x and z. Its
/// length is the speed along the arc if the clip turns, and 0 for a body that turns on the spot.
glm::dvec2 travel_velocity(const RootCurve& curve);

}  // namespace throng::anim
