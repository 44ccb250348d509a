#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace throng::mannequin {

inline constexpr std::size_t joint_count = 62;

/// A joint at rest. All joints are aligned with the world at rest, so the rest pose is positions alone.
struct Joint {
  std::string name;
  std::size_t parent;   ///< Index of the parent, always smaller than the joint's own; the root is its own parent.
  glm::dvec3 position;  ///< World position at rest in metres, A-pose, facing +Z, the character's left at +X.
};

/// The mannequin's joints, depth-first, the single root at the ground origin first.
const std::array<Joint, joint_count>& skeleton();

/// Index of a joint that must exist.
std::size_t joint_index(std::string_view name);

/// The joint on the other side of the body ("hand.L" for "hand.R"), or the joint itself on the centre line.
std::size_t mirrored_joint(std::size_t joint);

/// Frame of the left arm at rest: along the bones, towards the thumb, and out of the back of the hand.
struct ArmFrame {
  glm::dvec3 shoulder, along, thumbwards, backwards;
  /// A point `s` metres from the shoulder joint along the arm, offset towards the thumb and the back of the hand.
  [[nodiscard]] glm::dvec3 at(double s, double thumb = 0, double back = 0) const {
    return shoulder + along * s + thumbwards * thumb + backwards * back;
  }
};
const ArmFrame& left_arm();

inline constexpr double arm_rest_abduction = 0.8726646259971648;  ///< 50 degrees from hanging.
inline constexpr double elbow_distance = 0.285;                   ///< From the shoulder joint, metres.
inline constexpr double wrist_distance = 0.540;

inline constexpr std::size_t finger_count = 5;

/// A finger of the left hand at rest, slightly curled: its knuckles and its tip.
struct Finger {
  std::string_view name;
  std::array<glm::dvec3, 4> points;      ///< Three joints, then the tip.
  std::array<glm::dvec3, 3> directions;  ///< Of the three bones, unit length.
  double radius;                         ///< At the middle bone, metres.
};
const std::array<Finger, finger_count>& left_fingers();

}  // namespace throng::mannequin
