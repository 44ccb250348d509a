#pragma once

#include <cmath>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace throng::anim {

/// Returns whether no number of a vector or quaternion of GLM is infinite or NaN.
template <typename Vector>
bool all_finite(const Vector& value) {
  for (glm::length_t i = 0; i < Vector::length(); ++i) {
    if (!std::isfinite(value[i])) return false;
  }
  return true;
}

inline bool all_finite(const glm::dmat4& matrix) {
  return all_finite(matrix[0]) && all_finite(matrix[1]) && all_finite(matrix[2]) && all_finite(matrix[3]);
}

}  // namespace throng::anim
