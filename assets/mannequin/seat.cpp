#include <algorithm>
#include <array>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/at_ease.h"
#include "assets/mannequin/clip.h"
#include "assets/mannequin/curve.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

/// Of the hips from rest, on a seat 0.44 m high behind the feet.
constexpr dvec3 seated_hips{0, -0.405, -0.385};
constexpr std::array<double, 4> seated_pitch{-9, 5, 6, 4};  ///< Of hips, spine, chest and upper chest, degrees.
constexpr double on_thigh = 0.024;  ///< Metres from the joints of a hand that rests to the cloth below it.
constexpr std::array<const char*, 4> trunk{"hips", "spine", "chest", "upper_chest"};

/// A hand on the thigh.
ArmAngles resting(double phase, double late) {
  return {.flexion = 23 + 0.8 * wave(phase, 0.25 + late),
          .abduction = 9 + 0.8 * wave(phase, 0.22 + late, 2),
          .inward_twist = 22 + 1.2 * wave(phase, 0.40 + late),
          .elbow = 52 + 1.0 * wave(phase, 0.32 + late),
          .pronation = 62 + 2 * wave(phase, 0.45 + late),
          .wrist_flexion = -16 + 1.5 * wave(phase, 0.50 + late),
          .shrug = 1 + 0.9 * wave(phase, 0.20, 2),
          .reach = 2 + 0.7 * wave(phase, 0.24, 2)};
}

/// Metres from the thigh, which narrows towards the knee, to the nearest of palm and finger joints.
double above_thigh(const Pose& pose, Side side) {
  const WorldPose world = world_pose(pose);
  const std::string suffix = side == Side::left ? ".L" : ".R";
  const dvec3 hip = world[joint_index("thigh" + suffix)].position;
  const dvec3 thigh = world[joint_index("shin" + suffix)].position - hip;
  double nearest = 1;
  for (const char* part :
       {"hand", "thumb.3", "index.1", "index.3", "middle.1", "middle.3", "ring.3", "little.1", "little.3"}) {
    const dvec3 place = world[joint_index(part + suffix)].position;
    const double along = std::clamp(glm::dot(place - hip, thigh) / glm::dot(thigh, thigh), 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(place, hip + thigh * along) - glm::mix(0.100, 0.062, along));
  }
  return nearest;
}

/// Lifts or lowers the upper arm until the hand rests on the thigh; returns how the arm then is.
ArmAngles rest_hand(Pose& pose, Side side, ArmAngles arm) {
  double low = arm.flexion - 30;
  double high = arm.flexion + 60;
  for (int halving = 0; halving < 40; ++halving) {
    arm.flexion = 0.5 * (low + high);
    place_arm(pose, side, arm);
    (above_thigh(pose, side) < on_thigh ? low : high) = arm.flexion;
  }
  return arm;
}

/// Seated, two breaths and one look aside per cycle.
Pose seated(double phase) {
  Pose pose;
  const double shift = wave(phase, 0.25);
  const double breath = wave(phase, 0.20, 2);
  pose.hips = seated_hips + dvec3(0.006 * shift, 0.001 * breath, 0.004 * wave(phase, 0.1));
  pose["hips"] = turned(seated_pitch[0] + 0.6 * wave(phase, 0.6), 1.0 * wave(phase, 0.3), 0.8 * shift);
  pose["spine"] = turned(seated_pitch[1] - 0.4 * breath, 1.2 * wave(phase, 0.34), -0.6 * wave(phase, 0.27));
  pose["chest"] =
      turned(seated_pitch[2] - 0.9 * wave(phase, 0.22, 2), 1.4 * wave(phase, 0.37), -0.6 * wave(phase, 0.30));
  pose["upper_chest"] =
      turned(seated_pitch[3] - 0.8 * wave(phase, 0.24, 2), 1.0 * wave(phase, 0.40), -0.4 * wave(phase, 0.33));
  steady_head(pose, turned(2.0 + 1.2 * wave(phase, 0.70), 9.0 * wave(phase, 0.44), 1.4 * wave(phase, 0.50)));
  pose["eye.L"] = pose["eye.R"] = turned(1.5 * wave(phase, 0.55), 9 * wave(phase, 0.38), 0);
  stand(pose, 0);
  for (const Side side : {Side::left, Side::right}) {
    curl_fingers(pose, side,
                 [&](double late) { return 4 + 2 * wave(phase, (side == Side::left ? 0.3 : 0.7) + 0.08 * late); });
    rest_hand(pose, side, resting(side == Side::left ? phase : phase + 0.5, side == Side::left ? 0.0 : 0.06));
  }
  return pose;
}

double ramp(double time, double from, double to) {
  const double t = std::clamp((time - from) / (to - from), 0.0, 1.0);
  return t * t * t * (10 + t * (6 * t - 15));
}

/// Between standing at ease and being seated: each part has its own share of the way. `bow` leans the trunk forward,
/// which keeps the weight over the feet while there is no seat below it.
struct Lowering {
  double back, down, trunk, arms, hands, head, bow;
};

Pose between(const Lowering& way) {
  const Pose up = stand_at_ease(0, 2);
  Pose low = seated(0);
  Pose pose = up;
  pose.hips = {glm::mix(up.hips.x, low.hips.x, way.back), glm::mix(up.hips.y, low.hips.y, way.down),
               glm::mix(up.hips.z, low.hips.z, way.back)};
  constexpr std::array<double, 4> bows{26, 7, 6, 4};
  for (std::size_t part = 0; part < trunk.size(); ++part) {
    const std::size_t joint = joint_index(trunk[part]);
    pose.rotations[joint] =
        glm::slerp(up.rotations[joint], low.rotations[joint], way.trunk) * turned(bows[part] * way.bow, 0, 0);
  }
  const WorldPose standing = world_pose(up);
  const WorldPose sitting = world_pose(low);
  const std::size_t head = joint_index("head");
  steady_head(pose, glm::slerp(standing[head].rotation, sitting[head].rotation, way.head) * turned(17 * way.bow, 0, 0));
  for (const char* eye : {"eye.L", "eye.R"}) {
    pose[eye] = glm::slerp(up.rotations[joint_index(eye)], low.rotations[joint_index(eye)], way.head);
  }
  stand(pose, 0);
  for (const Side side : {Side::left, Side::right}) {
    const double own = side == Side::left ? 0.0 : 0.5;
    const double late = side == Side::left ? 0.0 : 0.06;
    const ArmAngles rested = rest_hand(low, side, resting(own, late));
    ArmAngles arm = mix(hanging(own, late), rested, way.arms);
    const ArmAngles hand = mix(hanging(own, late), rested, way.hands);
    arm.flexion += (side == Side::left ? 50 : 46) * way.bow;
    arm.abduction += 5 * way.bow;
    arm.elbow = hand.elbow + 6 * way.bow;
    arm.pronation = hand.pronation;
    arm.wrist_flexion = hand.wrist_flexion;
    curl_fingers(pose, side, [&](double lateness) {
      const double start = side == Side::left ? 0.3 : 0.7;
      return glm::mix(7 + 2.5 * wave(0, start + 0.08 * lateness), 4 + 2 * wave(0, start + 0.08 * lateness), way.hands);
    });
    place_arm(pose, side, arm);
    if (above_thigh(pose, side) < on_thigh) rest_hand(pose, side, arm);
  }
  return pose;
}

/// Down: the hips go back first, the trunk bows against it and comes up when the seat is there.
Pose lower(double time) {
  return between({.back = ramp(time, 0.04, 0.74),
                  .down = ramp(time, 0.10, 0.82),
                  .trunk = ramp(time, 0.45, 0.97),
                  .arms = ramp(time, 0.34, 0.92),
                  .hands = ramp(time, 0.42, 0.98),
                  .head = ramp(time, 0.30, 0.95),
                  .bow = ramp(time, 0.02, 0.50) - ramp(time, 0.58, 1.0)});
}

/// Up: the trunk bows until the weight is over the feet, only then does the seat come free.
Pose rise(double time) {
  return between({.back = 1 - ramp(time, 0.24, 0.86),
                  .down = 1 - ramp(time, 0.30, 0.94),
                  .trunk = 1 - ramp(time, 0.04, 0.62),
                  .arms = 1 - ramp(time, 0.30, 0.90),
                  .hands = 1 - ramp(time, 0.34, 0.98),
                  .head = 1 - ramp(time, 0.10, 0.80),
                  .bow = 1.12 * (ramp(time, 0.0, 0.42) - ramp(time, 0.48, 1.0))});
}

}  // namespace

Motion make_sit_down() { return {"sit down", 60, false, lower}; }
Motion make_sit() { return {"sit", 180, true, seated}; }
Motion make_stand_up() { return {"stand up", 54, false, rise}; }

}  // namespace throng::mannequin
