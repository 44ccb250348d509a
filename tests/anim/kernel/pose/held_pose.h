#pragma once

#include <random>
#include <string_view>
#include <vector>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/kernel/limb/joint_chain.h"
#include "engine/anim/kernel/pose/pose_view.h"

namespace throng::anim {

/// A whole pose in memory of its own. It is the bind pose at first. The packets lie apart, as they do in a local store.
class HeldPose {
 public:
  explicit HeldPose(const Skeleton& skeleton);

  PoseView view();
  const std::vector<float>& floats() const { return floats_; }
  bool is_finite() const;

  /// Turns every bone by up to `radians` and moves it by up to a centimetre.
  void shake(std::mt19937& random, float radians);

 private:
  int bone_count_;
  std::vector<float> floats_;
};

/// Returns a joint of the pose by 4x4 matrices in double, from the definition of a state: rotation from the bind pose
/// and position.
JointMotion joint_by_definition(const Skeleton& skeleton, const PoseView& pose, int bone);

/// Does the same by the name of the bone.
JointMotion joint_by_definition(const Skeleton& skeleton, const PoseView& pose, std::string_view bone);

/// Returns the largest difference between floats at the same places of two poses.
float largest_difference(const std::vector<float>& a, const std::vector<float>& b);

/// These two functions draw the same numbers on every machine.
float random_between(std::mt19937& random, float low, float high);
glm::vec3 random_direction(std::mt19937& random);

/// Returns the radians between two rotations.
float angle_between(const glm::quat& a, const glm::quat& b);

}  // namespace throng::anim
