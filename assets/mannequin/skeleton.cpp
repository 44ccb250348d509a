#include "assets/mannequin/skeleton.h"

#include <cassert>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

namespace throng::mannequin {
namespace {

using glm::dvec3;

/// Where a finger starts and how it lies: distances in metres along the arm, towards the thumb, out of the back.
struct FingerPlan {
  std::string_view name;
  double along, thumb, back, spread;
  std::array<double, 3> lengths;
  std::array<double, 3> curl;  ///< Of each bone against the hand, radians.
  double radius;
};

constexpr std::array<FingerPlan, 4> finger_plans{{
    {"index", 0.628, 0.0310, 0.001, 0.07, {0.042, 0.024, 0.021}, {0.16, 0.42, 0.60}, 0.0086},
    {"middle", 0.632, 0.0105, 0.002, 0.01, {0.046, 0.027, 0.023}, {0.20, 0.50, 0.70}, 0.0088},
    {"ring", 0.628, -0.0100, 0.001, -0.05, {0.043, 0.025, 0.022}, {0.24, 0.56, 0.76}, 0.0083},
    {"little", 0.618, -0.0295, -0.001, -0.13, {0.036, 0.019, 0.018}, {0.26, 0.58, 0.78}, 0.0073},
}};

Finger lay_finger(const ArmFrame& arm, const FingerPlan& plan) {
  Finger finger{plan.name, {}, {}, plan.radius};
  finger.points[0] = arm.at(plan.along, plan.thumb, plan.back);
  const dvec3 straight = arm.along * std::cos(plan.spread) + arm.thumbwards * std::sin(plan.spread);
  for (std::size_t bone = 0; bone < 3; ++bone) {
    finger.directions[bone] = straight * std::cos(plan.curl[bone]) - arm.backwards * std::sin(plan.curl[bone]);
    finger.points[bone + 1] = finger.points[bone] + finger.directions[bone] * plan.lengths[bone];
  }
  return finger;
}

Finger lay_thumb(const ArmFrame& arm) {
  Finger thumb{"thumb", {}, {}, 0.0104};
  const auto direction = [&](double along, double side, double back) {
    return glm::normalize(arm.along * along + arm.thumbwards * side + arm.backwards * back);
  };
  thumb.directions = {direction(0.62, 0.66, -0.36), direction(0.80, 0.46, -0.34), direction(0.90, 0.28, -0.34)};
  constexpr std::array<double, 3> lengths{0.042, 0.033, 0.026};
  thumb.points[0] = arm.at(0.560, 0.016, -0.006);
  for (std::size_t bone = 0; bone < 3; ++bone) {
    thumb.points[bone + 1] = thumb.points[bone] + thumb.directions[bone] * lengths[bone];
  }
  return thumb;
}

class SkeletonBuilder {
 public:
  std::size_t add(std::string name, std::size_t parent, dvec3 position) {
    joints_.push_back({std::move(name), parent, position});
    return joints_.size() - 1;
  }

  void add_arm(std::size_t chest, double side, const std::string& suffix) {
    const auto place = [side](dvec3 p) { return dvec3(p.x * side, p.y, p.z); };
    const ArmFrame& arm = left_arm();
    const auto shoulder = add("shoulder" + suffix, chest, place({0.030, 1.440, 0.005}));
    const auto upper = add("upper_arm" + suffix, shoulder, place(arm.shoulder));
    add("upper_arm_twist" + suffix, upper, place(arm.at(0.08)));
    const auto forearm = add("forearm" + suffix, upper, place(arm.at(elbow_distance)));
    add("forearm_twist" + suffix, forearm, place(arm.at(0.43)));
    const auto hand = add("hand" + suffix, forearm, place(arm.at(wrist_distance)));
    for (const Finger& finger : left_fingers()) {
      std::size_t parent = hand;
      for (std::size_t bone = 0; bone < 3; ++bone) {
        parent =
            add(std::string(finger.name) + "." + std::to_string(bone + 1) + suffix, parent, place(finger.points[bone]));
      }
    }
  }

  void add_leg(std::size_t hips, double side, const std::string& suffix) {
    const auto thigh = add("thigh" + suffix, hips, {0.092 * side, 0.925, 0.0});
    add("thigh_twist" + suffix, thigh, {0.094 * side, 0.80, 0.0});
    const auto shin = add("shin" + suffix, thigh, {0.098 * side, 0.495, 0.004});
    const auto foot = add("foot" + suffix, shin, {0.102 * side, 0.085, -0.022});
    add("toe" + suffix, foot, {0.106 * side, 0.016, 0.106});
  }

  std::array<Joint, joint_count> finish() {
    assert(joints_.size() == joint_count);
    std::array<Joint, joint_count> all;
    for (std::size_t j = 0; j < joint_count; ++j) all[j] = joints_[j];
    return all;
  }

 private:
  std::vector<Joint> joints_;
};

std::array<Joint, joint_count> build_skeleton() {
  SkeletonBuilder build;
  const auto root = build.add("root", 0, {0, 0, 0});
  const auto hips = build.add("hips", root, {0, 0.950, -0.005});
  const auto spine = build.add("spine", hips, {0, 1.050, -0.010});
  const auto chest = build.add("chest", spine, {0, 1.165, -0.015});
  const auto upper = build.add("upper_chest", chest, {0, 1.290, -0.015});
  const auto neck = build.add("neck", upper, {0, 1.475, -0.022});
  const auto head = build.add("head", neck, {0, 1.565, -0.008});
  build.add("jaw", head, {0, 1.615, 0.010});
  build.add("eye.L", head, {0.032, 1.677, 0.060});
  build.add("eye.R", head, {-0.032, 1.677, 0.060});
  build.add_arm(upper, 1, ".L");
  build.add_arm(upper, -1, ".R");
  build.add_leg(hips, 1, ".L");
  build.add_leg(hips, -1, ".R");
  return build.finish();
}

std::string other_side(std::string name) {
  if (name.ends_with(".L")) {
    name.back() = 'R';
  } else if (name.ends_with(".R")) {
    name.back() = 'L';
  }
  return name;
}

std::array<std::size_t, joint_count> find_mirrors() {
  std::array<std::size_t, joint_count> mirrors{};
  for (std::size_t j = 0; j < joint_count; ++j) mirrors[j] = joint_index(other_side(skeleton()[j].name));
  return mirrors;
}

}  // namespace

const std::array<Joint, joint_count>& skeleton() {
  static const std::array<Joint, joint_count> joints = build_skeleton();
  return joints;
}

std::size_t joint_index(std::string_view name) {
  for (std::size_t j = 0; j < joint_count; ++j) {
    if (skeleton()[j].name == name) return j;
  }
  assert(false && "every joint named by the generator exists");
  return 0;
}

std::size_t mirrored_joint(std::size_t joint) {
  static const std::array<std::size_t, joint_count> mirrors = find_mirrors();
  return mirrors[joint];
}

const ArmFrame& left_arm() {
  static const ArmFrame arm{{0.172, 1.425, -0.010},
                            {std::sin(arm_rest_abduction), -std::cos(arm_rest_abduction), 0},
                            {0, 0, 1},
                            {std::cos(arm_rest_abduction), std::sin(arm_rest_abduction), 0}};
  return arm;
}

const std::array<Finger, finger_count>& left_fingers() {
  static const std::array<Finger, finger_count> fingers{
      lay_thumb(left_arm()), lay_finger(left_arm(), finger_plans[0]), lay_finger(left_arm(), finger_plans[1]),
      lay_finger(left_arm(), finger_plans[2]), lay_finger(left_arm(), finger_plans[3])};
  return fingers;
}

}  // namespace throng::mannequin
