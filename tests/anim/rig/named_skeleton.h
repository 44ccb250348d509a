#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

struct NamedJoint {
  std::string name;
  std::string parent;  ///< name of one before it; empty for a root
  glm::vec3 origin;    ///< bind pose, model space
};

/// Returns a rigid skeleton of these joints, whose bind rotations are anything. Its rest pose is its bind pose.
Skeleton named_skeleton(const std::vector<NamedJoint>& joints);

/// Returns a person of 1.7 m facing +Z, standing on the ground with straight arms down and knees a little bent:
/// root, hips, spine, chest, neck, head, and upper_arm, forearm, hand, thigh, shin, foot, toe of .L and .R.
std::vector<NamedJoint> person_joints();

}  // namespace throng::anim
