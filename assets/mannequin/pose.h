#pragma once

#include <array>
#include <functional>
#include <string_view>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "assets/mannequin/skeleton.h"

namespace throng::mannequin {

enum class Side { left, right };

inline constexpr double degrees = 0.017453292519943295;  ///< One degree in radians.

/// A whole body at one time: joint rotations relative to rest, and the two joints that also move.
struct Pose {
  glm::dvec3 root{0};  ///< Ground position.
  glm::dvec3 hips{0};  ///< Offset of the hips from rest.
  std::array<glm::dquat, joint_count> rotations;

  Pose() { rotations.fill(glm::dquat(1, 0, 0, 0)); }
  glm::dquat& operator[](std::string_view joint) { return rotations[joint_index(joint)]; }
};

struct WorldJoint {
  glm::dvec3 position;
  glm::dquat rotation;
};
using WorldPose = std::array<WorldJoint, joint_count>;
WorldPose world_pose(const Pose& pose);

/// Rotations in degrees about +X (leaning forward for the trunk), +Y (turning to the left) and +Z.
glm::dquat turned(double pitch, double yaw, double roll);

/// A foot and the place where it shall be.
struct FootTarget {
  glm::dvec3 ankle;  ///< World position of the foot joint.
  double pitch;      ///< Degrees, positive with the toes up.
  double yaw;        ///< Degrees of turning out.
  double toe_bend;   ///< Degrees that the toes bend up against the foot.
};

/// Bends hip, knee and ankle so that the foot is at its target, the knee pointing where the foot does.
/// Returns by how many metres the leg is too short (0 when it reaches).
double place_leg(Pose& pose, Side side, const FootTarget& target);

/// An arm by its anatomical angles in degrees; all zero is hanging straight down with the thumb forward.
struct ArmAngles {
  double flexion = 0;       ///< Upper arm forward.
  double abduction = 0;     ///< Upper arm away from the body, before flexion.
  double inward_twist = 0;  ///< About the upper arm's own axis.
  double elbow = 0;
  double pronation = 0;      ///< Forearm, thumb turning inwards.
  double wrist_flexion = 0;  ///< Towards the palm.
  double shrug = 0;          ///< Collar bone up.
  double reach = 0;          ///< Collar bone forward.
};
void place_arm(Pose& pose, Side side, const ArmAngles& angles);
/// Angle by angle.
ArmAngles mix(const ArmAngles& from, const ArmAngles& to, double share);

/// Bends all fingers by so many degrees per joint beyond rest; negative opens the hand. `curl` is asked how late each
/// finger shall be, from 0 for the thumb's root to 1 for the tip of the little finger.
void curl_fingers(Pose& pose, Side side, const std::function<double(double late)>& curl);
/// The same for one finger, from 0 for the thumb to 4 for the little finger; all its joints bend at once.
void curl_finger(Pose& pose, Side side, std::size_t finger, double degrees_per_joint);

/// Turns neck and head so that the head faces `facing` in the world, whatever the trunk does.
void steady_head(Pose& pose, const glm::dquat& facing);

}  // namespace throng::mannequin
