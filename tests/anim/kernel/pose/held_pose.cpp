#include "tests/anim/kernel/pose/held_pose.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/asset/reference_pose.h"

namespace throng::anim {

namespace {
constexpr std::size_t gap_floats = 16;
constexpr std::size_t stride = static_cast<std::size_t>(rigid_components) * packet_bones + gap_floats;
}  // namespace

HeldPose::HeldPose(const Skeleton& skeleton)
    : bone_count_(skeleton.bone_count()),
      floats_(static_cast<std::size_t>(packets_for(skeleton.bone_count())) * stride, 0.0F) {
  for (int bone = 0; bone < packets_for(bone_count_) * packet_bones; ++bone) {
    view().set_rotation(bone, {1.0F, 0.0F, 0.0F, 0.0F});
  }
}

PoseView HeldPose::view() { return {.first = floats_.data(), .packet_stride = stride, .bone_count = bone_count_}; }

bool HeldPose::is_finite() const {
  return std::ranges::all_of(floats_, [](float value) { return std::isfinite(value); });
}

void HeldPose::shake(std::mt19937& random, float radians) {
  for (int bone = 0; bone < bone_count_; ++bone) {
    const glm::quat turn = glm::angleAxis(random_between(random, -radians, radians), random_direction(random));
    view().set_rotation(bone, glm::normalize(turn * view().rotation(bone)));
    view().set_position(bone, 0.01F * random_direction(random));
  }
}

JointMotion joint_by_definition(const Skeleton& skeleton, const PoseView& pose, int bone) {
  std::vector<StateTransform> locals;
  for (int b = 0; b < skeleton.bone_count(); ++b) {
    locals.push_back(to_local(skeleton, b, {.rotation = pose.rotation(b), .position = pose.position(b)}));
  }
  const auto index = static_cast<std::size_t>(bone);
  const glm::dmat4 global = pose_from_locals(skeleton, locals).globals[index];
  const glm::dmat3 turned(global / skeleton.references[index].scale);
  return {.rotation = glm::quat(glm::quat_cast(turned) * glm::conjugate(skeleton.references[index].rotation)),
          .position = glm::vec3(global[3])};
}

JointMotion joint_by_definition(const Skeleton& skeleton, const PoseView& pose, std::string_view bone) {
  return joint_by_definition(skeleton, pose, find_bone(skeleton, bone));
}

float largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
  float largest = 0.0F;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
  return largest;
}

float random_between(std::mt19937& random, float low, float high) {
  return low + (high - low) * static_cast<float>(random() >> 8U) / static_cast<float>(1U << 24U);
}

glm::vec3 random_direction(std::mt19937& random) {
  for (;;) {
    const glm::vec3 v(random_between(random, -1, 1), random_between(random, -1, 1), random_between(random, -1, 1));
    const float length = glm::length(v);
    if (length > 0.1F && length < 1.0F) return v / length;
  }
}

float angle_between(const glm::quat& a, const glm::quat& b) {
  const glm::quat turn = glm::conjugate(a) * b;
  return 2.0F * std::atan2(glm::length(glm::vec3(turn.x, turn.y, turn.z)), std::fabs(turn.w));
}

}  // namespace throng::anim
