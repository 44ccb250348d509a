#include <cmath>

#include "assets/mannequin/at_ease.h"
#include "assets/mannequin/clip.h"
#include "assets/mannequin/curve.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

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
    curl_fingers(pose, side, [&](double late) { return 58 + 5 * wave(own, 0.35 + 0.06 * late); });
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
             .inward_twist = -82 + 5 * wave(phase, 0.04, 4),
             .elbow = 92 - 22 * swing,
             .pronation = 14 + 5 * wave(phase, 0.06, 4),
             .wrist_flexion = -4,
             .shrug = 9 + wave(phase, 0.0, 4),
             .reach = 2});
  pose["hand.R"] = pose["hand.R"] * turned(0, 14 * wave(phase, 0.07, 4), 0);
  curl_fingers(pose, Side::right, [&](double late) { return -7 + 3 * wave(phase, 0.08 + 0.03 * late, 4); });
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
  bring_palms_together(pose, angles, 0.0045 + 0.105 * std::pow(open, 0.8));
  pose.hips = level.hips;
  for (const auto* joint : {"hips", "spine", "chest"}) pose[joint] = level.rotations[joint_index(joint)];
  pose["upper_chest"] = turned(1.0, 0, -0.3 * wave(phase, 0.33));
  steady_head(pose, turned(-2 + 1.6 * wave(phase, 0.10, claps), 3.0 * wave(phase, 0.40), 1.5 * wave(phase, 0.30)));
  for (const Side side : {Side::left, Side::right}) {
    curl_fingers(pose, side, [&](double late) { return -5 + 4 * wave(phase, 0.05 + 0.04 * late, claps); });
  }
  stand(pose, 0);
  return pose;
}

}  // namespace

Motion make_wave() { return {"wave", 72, true, greet}; }
Motion make_clap() { return {"clap", 36, true, applaud}; }
Motion make_cheer() { return {"cheer", 40, true, bounce_and_cheer}; }

}  // namespace throng::mannequin
