#include <cmath>

#include "assets/mannequin/clip.h"
#include "assets/mannequin/gait.h"

namespace throng::mannequin {
namespace {

/// Steps to the left, or to the right where `aside` is below zero: one foot goes out and the other follows it.
Gait stepping(double aside) {
  return {.frames = 30,
          .speed = 0,
          .aside = aside,
          .stance = 0.63,
          .foot_flat = -0.030,
          .foot_spread = 0.192,  // The feet are 16 cm apart where they are closest.
          .toe_out = 7,
          .pitch = {{{0.0, -9}, {0.08, 0}, {0.44, 0}, {0.55, -6}, {0.63, -17}, {0.74, -14}, {0.92, -9}}},
          .swing_height = 0.040,
          .peel = 0.40,
          .drop = 0.60,
          .crouch = 0.024,
          .bounce = 0.008,
          .bounce_peak = 0,
          .sway = 0.030,
          .pelvis_turn = 0,
          .pelvis_drop = 2.5,
          .chest_turn = 0,
          .lean = 3,
          .arm_swing = 4,
          .arm_forward = 5,
          .arm_spread = 12,
          .elbow = 30,
          .elbow_swing = 5,
          .curl = 8};
}

Pose side_step_pose(const Gait& gait, double phase) {
  const double to = gait.aside > 0 ? 1 : -1;
  const double lead = gait.aside > 0 ? phase : phase + 0.5;  // counts from the strike of the foot that goes out
  Pose pose;
  // Lowest where the feet are farthest apart.
  pose.hips = {gait.sway * wave(phase, 0.27), -gait.crouch - gait.bounce * wave(lead, 0.03),
               0.004 * wave(phase, 0.15, 2)};
  const double drop = gait.pelvis_drop * wave(phase, 0.17);
  pose["hips"] =
      turned(0.35 * gait.lean + 0.8 * wave(phase, 0.05, 2), to * (2 + 2.5 * wave(lead, 0.86)), drop - to * 1.5);
  pose["spine"] = turned(0.25 * gait.lean, to * 1.2 * wave(lead, 0.42), -0.55 * drop - to * 0.6 * wave(lead, 0.70));
  pose["chest"] = turned(0.25 * gait.lean + 0.5 * wave(phase, 0.12, 2), to * 1.4 * wave(lead, 0.46),
                         -0.55 * gait.pelvis_drop * wave(phase, 0.20));
  pose["upper_chest"] = turned(0.15 * gait.lean + 0.3 * wave(phase, 0.20, 2), to * 1.4 * wave(lead, 0.51),
                               -0.45 * gait.pelvis_drop * wave(phase, 0.24) + to * 0.8);
  // The eyes are where the way goes.
  steady_head(pose,
              turned(1.5 + 0.7 * wave(phase, 0.10, 2), to * (9 + 1.5 * wave(lead, 0.30)), 0.8 * wave(phase, 0.25)));
  pose["eye.L"] = pose["eye.R"] = turned(0, to * (5 + 2 * wave(lead, 0.80)), 0);
  for (const Side side : {Side::left, Side::right}) {
    const double own = side == Side::left ? phase : phase + 0.5;
    ArmAngles arm = swinging_arm(gait, own);
    arm.abduction += 3.5 * wave(lead, side == Side::left ? 0.10 : 0.16);  // both open when the feet do
    place_arm(pose, side, arm);
    curl_fingers(pose, side, [&](double late) { return gait.curl + 3 * wave(own, 0.62 + 0.05 * late); });
    step(pose, gait, side, own);
  }
  return pose;
}

}  // namespace

// A walk that keeps its heading while it goes aside a little. The feet stay a bit farther apart, so that they pass.
Motion make_veer(Side towards) {
  const bool left = towards == Side::left;
  Gait veer = walking();
  veer.speed = 1.2;
  veer.aside = left ? 0.4 : -0.4;
  veer.foot_spread = 0.100;
  return gait_clip(left ? "veer left" : "veer right", veer, stride_pose);
}

Motion make_side_step(Side towards) {
  const bool left = towards == Side::left;
  return gait_clip(left ? "step left" : "step right", stepping(left ? 0.45 : -0.45), side_step_pose);
}

}  // namespace throng::mannequin
