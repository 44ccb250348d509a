#include "assets/mannequin/pose.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace throng::mannequin {
namespace {

using glm::dquat;
using glm::dvec3;

constexpr dvec3 axis_x{1, 0, 0};
constexpr dvec3 axis_y{0, 1, 0};
constexpr dvec3 axis_z{0, 0, 1};
constexpr dquat identity{1, 0, 0, 0};

dquat about(dvec3 axis, double angle_in_degrees) { return glm::angleAxis(angle_in_degrees * degrees, axis); }

std::string on_side(std::string_view joint, Side side) {
  return std::string(joint) + (side == Side::left ? ".L" : ".R");
}

/// Rotation of the left body half as seen on `side`: reflected in the plane x = 0.
dquat sided(const dquat& left, Side side) {
  return side == Side::left ? left : dquat(left.w, left.x, -left.y, -left.z);
}

dvec3 bone_offset(std::string_view joint) {
  const Joint& bone = skeleton()[joint_index(joint)];
  return bone.position - skeleton()[bone.parent].position;
}

/// The part of a rotation that turns about `axis`.
dquat twist_about(const dquat& rotation, dvec3 axis) {
  const double along = glm::dot(dvec3(rotation.x, rotation.y, rotation.z), axis);
  return glm::normalize(dquat(rotation.w, axis * along));
}

/// Orthonormal frame with its second axis along `along` and its first as near to `across` as that allows.
glm::dmat3 frame(dvec3 along, dvec3 across) {
  const dvec3 y = glm::normalize(along);
  const dvec3 x = glm::normalize(across - y * glm::dot(across, y));
  return {x, y, glm::cross(x, y)};
}

void bend_finger(Pose& pose, Side side, const Finger& finger, int bone, double curl) {
  const dvec3 across_palm = glm::normalize(left_arm().thumbwards * -0.8 - left_arm().backwards * 0.6);
  const bool thumb = finger.name == "thumb";
  const dvec3 axis = thumb ? glm::normalize(glm::cross(finger.directions[1], across_palm)) : -axis_z;
  const double share = thumb ? (bone == 1 ? 0.3 : 0.6) : (bone == 3 ? 0.7 : 1.0);
  pose[on_side(std::string(finger.name) + "." + std::to_string(bone), side)] = sided(about(axis, curl * share), side);
}

}  // namespace

dquat turned(double pitch, double yaw, double roll) {
  return about(axis_y, yaw) * about(axis_x, pitch) * about(axis_z, roll);
}

WorldPose world_pose(const Pose& pose) {
  const auto& joints = skeleton();
  WorldPose world;
  world[0] = {pose.root, pose.rotations[0]};
  for (std::size_t j = 1; j < joint_count; ++j) {
    const WorldJoint& parent = world[joints[j].parent];
    dvec3 offset = joints[j].position - joints[joints[j].parent].position;
    if (j == 1) offset += pose.hips;
    world[j] = {parent.position + parent.rotation * offset, parent.rotation * pose.rotations[j]};
  }
  return world;
}

double place_leg(Pose& pose, Side side, const FootTarget& target) {
  const WorldPose world = world_pose(pose);
  const WorldJoint hips = world[joint_index("hips")];
  const dvec3 reach = target.ankle - world[joint_index(on_side("thigh", side))].position;
  const dvec3 thigh = bone_offset(on_side("shin", side));
  const dvec3 shin = bone_offset(on_side("foot", side));

  // |thigh + Rx(knee) shin| = |reach|, that is p cos(knee) + q sin(knee) = wanted.
  const double p = thigh.y * shin.y + thigh.z * shin.z;
  const double q = thigh.z * shin.y - thigh.y * shin.z;
  const double wanted =
      0.5 * (glm::dot(reach, reach) - glm::dot(thigh, thigh) - glm::dot(shin, shin)) - thigh.x * shin.x;
  const double cosine = wanted / std::hypot(p, q);
  const double knee = std::atan2(q, p) + std::acos(std::clamp(cosine, -1.0, 1.0));
  const dquat knee_turn = glm::angleAxis(knee, axis_x);

  const double outward = side == Side::left ? target.yaw : -target.yaw;
  const dquat foot = about(axis_y, outward) * about(axis_x, -target.pitch);
  const dvec3 straight = thigh + knee_turn * shin;
  const glm::dmat3 aim = frame(reach, about(axis_y, outward) * axis_x) * glm::transpose(frame(straight, axis_x));
  const dquat thigh_world = glm::normalize(glm::quat_cast(aim));
  const dquat thigh_local = glm::inverse(hips.rotation) * thigh_world;
  pose[on_side("thigh", side)] = thigh_local;
  pose[on_side("thigh_twist", side)] =
      glm::slerp(identity, glm::inverse(twist_about(thigh_local, glm::normalize(thigh))), 0.5);
  pose[on_side("shin", side)] = knee_turn;
  pose[on_side("foot", side)] = glm::inverse(thigh_world * knee_turn) * foot;
  pose[on_side("toe", side)] = about(axis_x, -target.toe_bend);
  return std::max(0.0, glm::length(reach) - glm::length(straight));
}

void place_arm(Pose& pose, Side side, const ArmAngles& angles) {
  const double rest = arm_rest_abduction / degrees;
  const dvec3 along = left_arm().along;
  const dvec3 elbow_axis = about(axis_z, rest) * -axis_x;
  const dquat upper = about(axis_x, -angles.flexion) * about(axis_z, angles.abduction) *
                      about(axis_y, -angles.inward_twist) * about(axis_z, -rest);
  const dquat pronation = about(along, angles.pronation);
  pose[on_side("shoulder", side)] = sided(about(axis_z, angles.shrug) * about(axis_y, -angles.reach), side);
  pose[on_side("upper_arm", side)] = sided(upper, side);
  pose[on_side("upper_arm_twist", side)] =
      sided(glm::slerp(identity, glm::inverse(twist_about(upper, along)), 0.5), side);
  pose[on_side("forearm", side)] = sided(about(elbow_axis, angles.elbow), side);
  pose[on_side("forearm_twist", side)] = sided(about(along, 0.5 * angles.pronation), side);
  pose[on_side("hand", side)] = sided(pronation * about(axis_z, -angles.wrist_flexion), side);
}

ArmAngles mix(const ArmAngles& from, const ArmAngles& to, double share) {
  const auto between = [&](double ArmAngles::*angle) { return glm::mix(from.*angle, to.*angle, share); };
  return {.flexion = between(&ArmAngles::flexion),
          .abduction = between(&ArmAngles::abduction),
          .inward_twist = between(&ArmAngles::inward_twist),
          .elbow = between(&ArmAngles::elbow),
          .pronation = between(&ArmAngles::pronation),
          .wrist_flexion = between(&ArmAngles::wrist_flexion),
          .shrug = between(&ArmAngles::shrug),
          .reach = between(&ArmAngles::reach)};
}

void curl_fingers(Pose& pose, Side side, const std::function<double(double late)>& curl) {
  for (std::size_t finger = 0; finger < finger_count; ++finger) {
    for (int bone = 1; bone <= 3; ++bone) {
      bend_finger(pose, side, left_fingers()[finger], bone, curl(0.2 * static_cast<double>(finger) + 0.1 * (bone - 1)));
    }
  }
}

void curl_finger(Pose& pose, Side side, std::size_t finger, double degrees_per_joint) {
  for (int bone = 1; bone <= 3; ++bone) bend_finger(pose, side, left_fingers()[finger], bone, degrees_per_joint);
}

void steady_head(Pose& pose, const dquat& facing) {
  const dquat chest = world_pose(pose)[joint_index("upper_chest")].rotation;
  const dquat correction = glm::inverse(chest) * facing;
  pose["neck"] = glm::slerp(identity, correction, 0.4);
  pose["head"] = glm::inverse(pose["neck"]) * correction;
}

}  // namespace throng::mannequin
