#include "assets/mannequin/reach.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace throng::mannequin {
namespace {

using glm::dquat;
using glm::dvec3;

constexpr double upper_length = elbow_distance;
constexpr double forearm_length = wrist_distance - elbow_distance;
constexpr double least_bend = 0.02;  // radians: a straight arm has no elbow that points anywhere

std::string of_side(std::string_view joint, Side side) {
  return std::string(joint) + (side == Side::left ? ".L" : ".R");
}

dvec3 reflected(dvec3 v, Side side) { return side == Side::left ? v : dvec3(-v.x, v.y, v.z); }
dquat reflected(const dquat& q, Side side) { return side == Side::left ? q : dquat(q.w, q.x, -q.y, -q.z); }

/// The rotation that turns one pair of orthogonal directions into another.
dquat turning(dvec3 first, dvec3 second, dvec3 to_first, dvec3 to_second) {
  const glm::dmat3 from(first, second, glm::cross(first, second));
  const glm::dmat3 to(to_first, to_second, glm::cross(to_first, to_second));
  return glm::normalize(glm::quat_cast(to * glm::transpose(from)));
}

dvec3 across(dvec3 v, dvec3 along) { return glm::normalize(v - along * glm::dot(v, along)); }

dquat turn_about(const dquat& rotation, dvec3 axis) {
  return glm::normalize(dquat(rotation.w, axis * glm::dot(dvec3(rotation.x, rotation.y, rotation.z), axis)));
}

dquat half(const dquat& rotation) { return glm::slerp(dquat(1, 0, 0, 0), rotation, 0.5); }

}  // namespace

dvec3 in_hand(double along, double thumb, double palm) {
  return left_arm().along * along + left_arm().thumbwards * thumb - left_arm().backwards * palm;
}

dquat palm_towards(Side side, dvec3 palm, dvec3 fingers) {
  const dvec3 faced = glm::normalize(reflected(palm, side));
  const ArmFrame& arm = left_arm();
  return reflected(turning(-arm.backwards, arm.along, faced, across(reflected(fingers, side), faced)), side);
}

dquat fingers_towards(Side side, dvec3 fingers, dvec3 palm) {
  const dvec3 along = glm::normalize(reflected(fingers, side));
  const ArmFrame& arm = left_arm();
  return reflected(turning(arm.along, -arm.backwards, along, across(reflected(palm, side), along)), side);
}

dquat thumb_towards(Side side, dvec3 thumb, dvec3 palm) {
  const dvec3 up = glm::normalize(reflected(thumb, side));
  const ArmFrame& arm = left_arm();
  return reflected(turning(arm.thumbwards, -arm.backwards, up, across(reflected(palm, side), up)), side);
}

HandTarget mix(const HandTarget& from, const HandTarget& to, double share) {
  return {.grip = glm::mix(from.grip, to.grip, share),
          .rotation = glm::slerp(from.rotation, to.rotation, share),
          .held = glm::mix(from.held, to.held, share),
          .elbow = glm::mix(from.elbow, to.elbow, share)};
}

double place_hand(Pose& pose, Side side, const HandTarget& target) {
  const WorldPose world = world_pose(pose);
  const dquat collar = reflected(world[joint_index(of_side("shoulder", side))].rotation, side);
  const dvec3 shoulder = reflected(world[joint_index(of_side("upper_arm", side))].position, side);
  const dquat hand = reflected(target.rotation, side);
  const dvec3 way = reflected(target.grip, side) - hand * target.held - shoulder;

  const double distance = glm::length(way);
  const double product = 2 * upper_length * forearm_length;
  const double cosine = (distance * distance - upper_length * upper_length - forearm_length * forearm_length) / product;
  const double bend = std::max(least_bend, std::acos(std::clamp(cosine, -1.0, 1.0)));
  const double aside = std::atan2(forearm_length * std::sin(bend), upper_length + forearm_length * std::cos(bend));
  const dvec3 straight = way / distance;
  const dvec3 outward = across(reflected(target.elbow, side), straight);

  const dvec3 along = left_arm().along;
  const dvec3 hinge = glm::normalize(glm::cross(along, dvec3(0, 0, 1)));
  const dvec3 upper_way = straight * std::cos(aside) + outward * std::sin(aside);
  const dquat upper = turning(along, hinge, upper_way, glm::cross(outward, straight));
  const dquat upper_local = glm::inverse(collar) * upper;
  const dquat elbow = glm::angleAxis(bend, hinge);
  const dquat hand_local = glm::inverse(upper * elbow) * hand;
  pose[of_side("upper_arm", side)] = reflected(upper_local, side);
  pose[of_side("upper_arm_twist", side)] = reflected(half(glm::inverse(turn_about(upper_local, along))), side);
  pose[of_side("forearm", side)] = reflected(elbow, side);
  pose[of_side("forearm_twist", side)] = reflected(half(turn_about(hand_local, along)), side);
  pose[of_side("hand", side)] = reflected(hand_local, side);
  return std::max(0.0, distance - upper_length - forearm_length);
}

Carried::Carried(const Pose& pose, std::string_view joint)
    : posed_(world_pose(pose)[joint_index(joint)]), rest_(skeleton()[joint_index(joint)].position) {}

}  // namespace throng::mannequin
