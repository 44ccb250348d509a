#include <cmath>

#include "assets/mannequin/clip.h"
#include "assets/mannequin/curve.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

/// Both feet where they stand at rest, the heels lifted by so many degrees about the balls.
double stand(Pose& pose, double heel_lift) {
  double missing = 0;
  for (const Side side : {Side::left, Side::right}) {
    const dvec3 ankle = skeleton()[joint_index("foot.L")].position;
    const dvec3 ball = skeleton()[joint_index("toe.L")].position - ankle;
    constexpr double toe_out = 9;
    const double outward = side == Side::left ? toe_out : -toe_out;
    const glm::dquat flat = turned(0, outward, 0);
    const dvec3 across(side == Side::left ? 1 : -1, 1, 1);
    const dvec3 pivot = flat * (ball * across);
    const dvec3 rolled = turned(heel_lift, outward, 0) * (ball * across);
    missing += place_leg(pose, side, {ankle * across + pivot - rolled, -heel_lift, toe_out, heel_lift});
  }
  return missing;
}

ArmAngles hanging(double phase, double late) {
  return {.flexion = 1 + 1.6 * wave(phase, 0.30 + late),
          .abduction = 8 + 0.9 * wave(phase, 0.22 + late, 2),
          .inward_twist = 4 + 2 * wave(phase, 0.40 + late),
          .elbow = 17 + 2.2 * wave(phase, 0.36 + late),
          .pronation = 14 + 2 * wave(phase, 0.45 + late),
          .wrist_flexion = 3 + 1.6 * wave(phase, 0.50 + late),
          .shrug = 0.9 * wave(phase, 0.20, 2),
          .reach = 1.0 + 0.7 * wave(phase, 0.24, 2)};
}

/// Standing at ease: the weight shifts once per cycle.
Pose stand_at_ease(double phase, int breaths) {
  Pose pose;
  const double shift = wave(phase, 0.25);
  const double breath = wave(phase, 0.20, breaths);
  pose.hips = {0.020 * shift, -0.006 - 0.002 * wave(phase, 0.25, 2), 0.004 * wave(phase, 0.10)};
  pose["hips"] = turned(-1.0 + 0.4 * wave(phase, 0.60), 1.6 * wave(phase, 0.30), 1.8 * shift);
  pose["spine"] = turned(0.6 - 0.3 * breath, -0.8 * wave(phase, 0.33), -1.1 * wave(phase, 0.27));
  pose["chest"] = turned(1.0 - 0.9 * breath, -0.6 * wave(phase, 0.36), -0.9 * wave(phase, 0.29));
  pose["upper_chest"] =
      turned(1.2 - 0.8 * wave(phase, 0.23, breaths), -0.5 * wave(phase, 0.40), -0.4 * wave(phase, 0.31));
  steady_head(pose, turned(1.5 + 0.9 * wave(phase, 0.70), 4.0 * wave(phase, 0.15), 1.2 * wave(phase, 0.45)));
  // The eyes arrive before the head does.
  pose["eye.L"] = pose["eye.R"] = turned(1.5 * wave(phase, 0.55), 7 * wave(phase, 0.06) + 3 * wave(phase, 0.40, 2), 0);
  for (const Side side : {Side::left, Side::right}) {
    place_arm(pose, side, hanging(side == Side::left ? phase : phase + 0.5, side == Side::left ? 0.0 : 0.06));
    curl_fingers(pose, side, 7 + 2.5 * wave(phase, side == Side::left ? 0.3 : 0.7));
  }
  stand(pose, 0);
  return pose;
}

/// Two bounces per cycle, the arms up and pumping by turns.
Pose bounce_and_cheer(double phase) {
  Pose pose;
  const double bounce = wave(phase, 0.25, 2);
  pose.hips = {0.014 * wave(phase, 0.25), -0.034 + 0.066 * bounce, -0.008 + 0.006 * wave(phase, 0.05, 2)};
  const double heel_lift = 13 + 13 * wave(phase, 0.27, 2);
  pose["hips"] = turned(3.0 - 3.0 * bounce, 4 * wave(phase, 0.2), 2.0 * wave(phase, 0.25));
  pose["spine"] = turned(-2.0 - 2.0 * wave(phase, 0.28, 2), 1.5 * wave(phase, 0.25), -2 * wave(phase, 0.28));
  pose["chest"] = turned(-3.0 - 2.0 * wave(phase, 0.30, 2), 3.0 * wave(phase, 0.28), -3 * wave(phase, 0.32));
  pose["upper_chest"] = turned(-3.0 - 1.5 * wave(phase, 0.33, 2), 2.0 * wave(phase, 0.30), -1 * wave(phase, 0.36));
  steady_head(pose, turned(-9.0 - 3.5 * wave(phase, 0.36, 2), 5.0 * wave(phase, 0.40), -3 * wave(phase, 0.45)));
  pose["jaw"] = turned(9 + 4 * wave(phase, 0.30, 2), 0, 0);
  for (const Side side : {Side::left, Side::right}) {
    const double own = side == Side::left ? phase : phase + 0.5;
    const double pump = wave(own, 0.30);
    const double jolt = wave(own, 0.34, 2);
    place_arm(pose, side,
              {.flexion = 20 + 6 * jolt,
               .abduction = 140 + 9 * pump + 4 * jolt,
               .inward_twist = -30 + 8 * wave(own, 0.40),
               .elbow = 42 - 24 * pump - 7 * wave(own, 0.40, 2),
               .pronation = 10 + 12 * wave(own, 0.45),
               .wrist_flexion = -6 + 14 * wave(own, 0.48),
               .shrug = 17 + 4 * pump,
               .reach = 3});
    curl_fingers(pose, side, 58 + 5 * wave(own, 0.35));
  }
  stand(pose, heel_lift);
  return pose;
}

/// At ease, but for the right hand, which waves four times.
Pose greet(double phase) {
  Pose pose = stand_at_ease(phase, 1);
  pose["upper_chest"] = pose["upper_chest"] * turned(-1, -2 + wave(phase, 0.2, 4), 2.5);
  steady_head(pose,
              turned(-1 + 1.2 * wave(phase, 0.10, 2), -6 + 2 * wave(phase, 0.3), -3 + 1.5 * wave(phase, 0.15, 2)));
  const double swing = wave(phase, 0.02, 4);
  place_arm(pose, Side::right,
            {.flexion = 12 + 2 * wave(phase, 0.05, 4),
             .abduction = 88 + 4 * wave(phase, 0.0, 4),
             .inward_twist = -88 + 6 * wave(phase, 0.04, 4),
             .elbow = 92 - 22 * swing,
             .pronation = 14 + 5 * wave(phase, 0.06, 4),
             .wrist_flexion = -4,
             .shrug = 9 + wave(phase, 0.0, 4),
             .reach = 2});
  pose["hand.R"] = pose["hand.R"] * turned(0, 14 * wave(phase, 0.07, 4), 0);
  curl_fingers(pose, Side::right, -7 + 3 * wave(phase, 0.09, 4));
  return pose;
}

/// How far the middle of the left palm lies from the plane between the hands.
double palm_gap(const Pose& pose) {
  const std::size_t hand = joint_index("hand.L");
  const dvec3 palm = left_arm().at(wrist_distance + 0.070, 0, -0.014) - skeleton()[hand].position;
  const WorldJoint placed = world_pose(pose)[hand];
  return (placed.position + placed.rotation * palm).x;
}

/// Turns the upper arms inwards until each palm is `gap` metres from the middle.
void bring_palms_together(Pose& pose, ArmAngles angles, double gap) {
  double low = -40;
  double high = 90;
  for (int halving = 0; halving < 40; ++halving) {
    angles.inward_twist = 0.5 * (low + high);
    place_arm(pose, Side::left, angles);
    (palm_gap(pose) > gap ? low : high) = angles.inward_twist;
  }
  place_arm(pose, Side::right, angles);
}

/// Two claps per cycle in front of the breast, the body nodding along.
Pose applaud(double phase) {
  constexpr double claps = 2;
  Pose pose;
  const double beat = wave(phase, 0.0, claps);
  pose.hips = {0.008 * wave(phase, 0.25), -0.008 + 0.003 * wave(phase, 0.10, claps), 0};
  pose["hips"] = turned(-0.5 + 0.5 * beat, 0, 0.9 * wave(phase, 0.25));
  pose["spine"] = turned(0.5 + 0.6 * wave(phase, 0.04, claps), 0, -0.5 * wave(phase, 0.28));
  pose["chest"] = turned(1.0 + 0.8 * wave(phase, 0.06, claps), 0, -0.5 * wave(phase, 0.31));
  const Pose level = pose;
  const double open = 0.5 - 0.5 * beat;
  const ArmAngles angles{.flexion = 36 + 4 * open,
                         .abduction = 12 + 5 * open,
                         .elbow = 98 - 4 * wave(phase, 0.03, claps),
                         .pronation = -8 + 6 * open,
                         .wrist_flexion = -30 + 22 * open + 4 * wave(phase, 0.36, claps),
                         .shrug = 2 + beat,
                         .reach = 6 - 2 * open};
  pose["chest"] = pose["spine"] = pose["hips"] = turned(0, 0, 0);
  pose.hips.x = 0;
  bring_palms_together(pose, angles, 0.003 + 0.105 * std::pow(open, 0.8));
  pose.hips = level.hips;
  for (const auto* joint : {"hips", "spine", "chest"}) pose[joint] = level.rotations[joint_index(joint)];
  pose["upper_chest"] = turned(1.0, 0, -0.3 * wave(phase, 0.33));
  steady_head(pose, turned(-2 + 1.6 * wave(phase, 0.10, claps), 3.0 * wave(phase, 0.40), 1.5 * wave(phase, 0.30)));
  for (const Side side : {Side::left, Side::right}) curl_fingers(pose, side, -5 + 4 * wave(phase, 0.06, claps));
  stand(pose, 0);
  return pose;
}

}  // namespace

Clip make_idle() {
  return sample_loop("idle", 180, 0, [](double phase) { return stand_at_ease(phase, 2); });
}
Clip make_wave() { return sample_loop("wave", 72, 0, greet); }
Clip make_clap() { return sample_loop("clap", 36, 0, applaud); }
Clip make_cheer() { return sample_loop("cheer", 40, 0, bounce_and_cheer); }

}  // namespace throng::mannequin
