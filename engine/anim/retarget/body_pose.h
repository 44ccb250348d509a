#pragma once

#include <span>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// Holds the places and rotations of a skeleton's joints, in model space, one element a bone.
struct BodyPose {
  std::vector<glm::dquat> rotations;  ///< unit
  std::vector<glm::dvec3> places;     ///< metres

  const glm::dquat& rotation(int bone) const { return rotations[static_cast<std::size_t>(bone)]; }
  const glm::dvec3& place(int bone) const { return places[static_cast<std::size_t>(bone)]; }
};

/// Returns how far the highest joint is above the lowest.
double height_of(const BodyPose& pose);

/// Returns the rotation of a matrix without shear.
glm::dquat rotation_of(const glm::dmat4& matrix);

/// Returns the bind pose, or the rest pose on the general path, as find_limbs() reads it.
BodyPose bind_pose(const Skeleton& skeleton);
BodyPose pose_of(std::span<const glm::dmat4> globals);

/// Returns the turn over the shorter arc that takes one direction to another; the identity where one has no length.
glm::dquat turn_between(const glm::dvec3& from, const glm::dvec3& to);

}  // namespace throng::anim
