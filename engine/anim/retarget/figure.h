#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/retarget/body_pose.h"
#include "engine/anim/rig/rig_map.h"

namespace throng::anim {

/// A foot that is higher than the other by so much of the leg does not stand.
inline constexpr double raised = 0.04;

/// A skeleton with its reference pose and the lengths that retargeting compares.
struct Figure {
  const Skeleton& skeleton;
  const RigMap& rig;
  BodyPose pose;
  std::optional<LimbBones> left_leg = {}, right_leg = {};
  double ground = 0.0;  ///< height of the soles in the reference pose
  double leg = 0.0;     ///< thigh and shin; 0 without legs
  double ankle = 0.0;   ///< height of the ankles that stand, above the ground

  double leg_length() const { return leg + ankle; }
};

std::vector<const LimbBones*> legs_of(const Figure& figure);

/// How a body carries its trunk in the reference pose.
enum class Carriage : unsigned char {
  unknown,  ///< it lacks arms or legs, or lies between the two
  upright,  ///< the trunk goes on where the legs end, as a person's does
  bent      ///< the trunk lies across the legs, as in an animal on four feet, or a person who sits
};
Carriage carriage_of(const Figure& figure);

/// Measures a skeleton. It and its rig must outlive the figure.
Figure figure_of(const Skeleton& skeleton, const RigMap& rig);

}  // namespace throng::anim
