#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace throng::anim {

/// The part of a body that a bone plays. The words are those of VRM 1.0 (VRMC_vrm, humanoid.humanBones), which VRM 0.x
/// has too. Eyes, jaw and fingers are not among them.
enum class BodyRole : unsigned char {
  hips,
  spine,
  chest,
  upper_chest,
  neck,
  head,
  left_shoulder,
  left_upper_arm,
  left_lower_arm,
  left_hand,
  left_upper_leg,
  left_lower_leg,
  left_foot,
  left_toes,
  right_shoulder,
  right_upper_arm,
  right_lower_arm,
  right_hand,
  right_upper_leg,
  right_lower_leg,
  right_foot,
  right_toes,
};

inline constexpr std::array<std::string_view, 22> body_role_names{
    "hips",          "spine",         "chest",         "upperChest",    "neck",          "head",
    "leftShoulder",  "leftUpperArm",  "leftLowerArm",  "leftHand",      "leftUpperLeg",  "leftLowerLeg",
    "leftFoot",      "leftToes",      "rightShoulder", "rightUpperArm", "rightLowerArm", "rightHand",
    "rightUpperLeg", "rightLowerLeg", "rightFoot",     "rightToes"};
inline constexpr std::size_t body_role_count = body_role_names.size();

constexpr std::size_t index_of(BodyRole role) { return static_cast<std::size_t>(role); }
constexpr std::string_view name_of(BodyRole role) { return body_role_names[index_of(role)]; }

/// Returns the role of that name, in VRM's spelling; nothing for any other word.
constexpr std::optional<BodyRole> body_role_named(std::string_view name) {
  for (std::size_t role = 0; role < body_role_count; ++role) {
    if (body_role_names[role] == name) return static_cast<BodyRole>(role);
  }
  return std::nullopt;
}

}  // namespace throng::anim
