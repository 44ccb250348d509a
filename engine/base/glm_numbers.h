#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "throng/math.h"

/// Converts the public numbers to GLM's, and back.
namespace throng {

inline glm::vec3 to_glm(const Vec3& v) { return {v.x, v.y, v.z}; }
inline glm::quat to_glm(const Quat& q) { return {q.w, q.x, q.y, q.z}; }  // GLM takes w first
inline Vec3 from_glm(const glm::vec3& v) { return {v.x, v.y, v.z}; }
inline glm::mat4 to_glm(const Mat4& m) { return glm::make_mat4(&m.columns[0][0]); }
inline Quat from_glm(const glm::quat& q) { return {q.x, q.y, q.z, q.w}; }

}  // namespace throng
