#include "engine/anim/retarget/body_pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/base/elementary.h"

namespace throng::anim {

double height_of(const BodyPose& pose) {
  const auto [low, high] = std::ranges::minmax_element(pose.places, {}, &glm::dvec3::y);
  return high->y - low->y;
}

glm::dquat rotation_of(const glm::dmat4& matrix) {
  glm::dmat3 axes(matrix);
  for (int axis = 0; axis < 3; ++axis) {
    const double length = glm::length(axes[axis]);
    if (!(length > 0.0)) return {1.0, 0.0, 0.0, 0.0};
    axes[axis] /= length;
  }
  if (glm::determinant(axes) < 0.0) axes[0] = -axes[0];
  return glm::normalize(glm::quat_cast(axes));
}

BodyPose pose_of(std::span<const glm::dmat4> globals) {
  BodyPose pose;
  for (const glm::dmat4& global : globals) {
    pose.rotations.push_back(rotation_of(global));
    pose.places.emplace_back(global[3]);
  }
  return pose;
}

BodyPose bind_pose(const Skeleton& skeleton) {
  if (!skeleton.rigid) return pose_of(reference_pose(skeleton, nullptr, 0.0).globals);
  BodyPose pose;
  for (const ReferenceFrame& frame : skeleton.references) {
    pose.rotations.push_back(frame.rotation);
    pose.places.push_back(frame.origin);
  }
  return pose;
}

glm::dquat turn_between(const glm::dvec3& from, const glm::dvec3& to) {
  constexpr double shortest = 1e-9;
  if (!(glm::length(from) > shortest) || !(glm::length(to) > shortest)) return {1.0, 0.0, 0.0, 0.0};
  const glm::dvec3 a = glm::normalize(from), b = glm::normalize(to);
  const double cosine = glm::dot(a, b);
  if (cosine < -1.0 + 1e-9) {  // half a turn about any axis across
    const glm::dvec3 across = glm::cross(a, std::abs(a.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    return angle_axis(std::numbers::pi, glm::normalize(across));
  }
  const glm::dvec3 axis = glm::cross(a, b);
  return glm::normalize(glm::dquat(1.0 + cosine, axis.x, axis.y, axis.z));
}

}  // namespace throng::anim
