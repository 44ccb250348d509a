#pragma once

#include <cmath>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace throng::anim {

/// Directions and rotations for changes of single bones. They use only additions, multiplications, divisions and square
/// roots, in a fixed order. So they give the same bits on every machine, which the sine of a C library does not
/// promise.

/// Returns `v` at length 1; `otherwise` where it is shorter than 1e-12, or not finite.
glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise);

/// Returns `v` at length 1, or, where unit_or would take another, some unit vector at a right angle to `unit`.
glm::vec3 unit_or_perpendicular(const glm::vec3& v, const glm::vec3& unit);

/// Returns some unit vector at a right angle to `unit`.
glm::vec3 any_perpendicular(const glm::vec3& unit);

/// Returns the part of `v` that is perpendicular to `unit`.
glm::vec3 perpendicular_part(const glm::vec3& v, const glm::vec3& unit);

/// Returns the shortest rotation between two unit vectors. Opposite ones turn about some axis at a right angle to them.
glm::quat shortest_turn(const glm::vec3& from, const glm::vec3& to);

/// Returns the same rotation, limited to the angle whose cosine is `least_cosine`.
glm::quat limited_turn(const glm::vec3& from, const glm::vec3& to, float least_cosine);

/// Returns the rotation about a unit axis, counter-clockwise seen from its tip, by `radians` of -pi to pi; to 2e-7.
glm::quat turn_about(const glm::vec3& axis, float radians);

/// Returns the angle of the point (x, y) from the x axis, -pi to pi, to 3e-7; 0 for (0, 0).
float angle_of(float y, float x);

/// Interpolates over the shorter arc: 0 gives `from`, 1 gives `to` or its negative. The result is unit.
glm::quat mix_rotations(const glm::quat& from, const glm::quat& to, float weight);

bool is_finite(const glm::vec3& v);

inline constexpr float farthest_place = 1e9F;  ///< metres
/// Returns whether a place is finite and within a million kilometres, so that distances to it are finite too.
inline bool is_place(const glm::vec3& v) {
  return std::fabs(v.x) < farthest_place && std::fabs(v.y) < farthest_place && std::fabs(v.z) < farthest_place;
}

}  // namespace throng::anim
