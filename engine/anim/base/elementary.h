#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace throng::anim {

// Functions of angles whose results are the same bits on every system. Each is made of operations that IEEE 754 rounds
// in one way: sums, products, quotients and square roots. Libraries of C and GLM, which calls them, round sines each in
// their own way, and a pose that depends on one differs from system to system (tests/house forbids them).

/// At most 0.57 units in the last place off: evaluated in doubles, rounded once. The polynomials are of degree 7
/// and 8 that come nearest to sin(x) / x and cos(x) within an eighth of a turn.
float sine(float angle);
float cosine(float angle);

/// At most 1 unit in the last place off, up to a million; farther away the angle counts as if off by 4e-17 of itself.
double sine(double angle);
double cosine(double angle);

/// Returns the angle of a point seen from the origin, from -pi to pi: 2 units in the last place. Both are finite.
double arc_tangent(double y, double x);

/// Returns an angle from 0 to pi: 2 units in the last place. The cosine is within -1 and 1.
double arc_cosine(double cosine);

/// 1 unit in the last place.
double cube_root(double value);

/// Returns the turn by an angle about an axis of length 1.
glm::quat angle_axis(float angle, const glm::vec3& axis);
glm::dquat angle_axis(double angle, const glm::dvec3& axis);

}  // namespace throng::anim
