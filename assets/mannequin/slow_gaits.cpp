#include "assets/mannequin/clip.h"
#include "assets/mannequin/gait.h"

namespace throng::mannequin {

// The ball of the foot comes down first and the heel leaves last. Nobody sees where he goes, so steps are short.
Motion make_walk_back() {
  constexpr Gait walk_back{.frames = 30,
                           .speed = -0.8,
                           .stance = 0.62,
                           .foot_flat = -0.050,
                           .foot_spread = 0.082,
                           .toe_out = 7,
                           .pitch = {{{0.0, -14}, {0.12, 0}, {0.40, 0}, {0.52, 5}, {0.62, 16}, {0.74, 6}, {0.92, -14}}},
                           .swing_height = 0.045,
                           .peel = 0.35,
                           .drop = 0.45,
                           .crouch = 0.027,
                           .bounce = 0.012,
                           .bounce_peak = 0.30,
                           .sway = 0.022,
                           .pelvis_turn = -4,
                           .pelvis_drop = 3,
                           .chest_turn = -3.5,
                           .lean = 3,
                           .arm_swing = -11,
                           .arm_forward = 3,
                           .arm_spread = 12,
                           .elbow = 25,
                           .elbow_swing = -6,
                           .curl = 8};
  return gait_clip("walk back", walk_back, stride_pose);
}

// The shuffle of who does not get on.
Motion make_step_in_place() {
  constexpr Gait step_in_place{
      .frames = 40,
      .speed = 0,
      .stance = 0.68,
      .foot_flat = -0.045,
      .foot_spread = 0.088,
      .toe_out = 8,
      .pitch = {{{0.0, 0}, {0.06, 0}, {0.46, 0}, {0.58, -6}, {0.68, -18}, {0.78, -14}, {0.93, -3}}},
      .swing_height = 0.026,
      .peel = 0.5,
      .drop = 0.6,
      .crouch = 0.014,
      .bounce = 0.004,
      .bounce_peak = 0.32,
      .sway = 0.030,
      .pelvis_turn = 1.5,
      .pelvis_drop = 2.5,
      .chest_turn = 1,
      .lean = 1.5,
      .arm_swing = 2,
      .arm_forward = 2,
      .arm_spread = 7,
      .elbow = 18,
      .elbow_swing = 2,
      .curl = 7};
  return gait_clip("step in place", step_in_place, stride_pose);
}

// Three steps in two seconds on nearly flat feet, as in a queue that moves on. The weight goes far from foot to foot.
Motion make_shuffle() {
  constexpr Gait shuffle{.frames = 40,
                         .speed = 0.45,
                         .stance = 0.68,
                         .foot_flat = -0.045,
                         .foot_spread = 0.086,
                         .toe_out = 8,
                         .pitch = {{{0.0, 7}, {0.06, 0}, {0.46, 0}, {0.58, -7}, {0.68, -22}, {0.78, -13}, {0.93, 7}}},
                         .swing_height = 0.022,
                         .peel = 0.5,
                         .drop = 0.75,
                         .crouch = 0.022,
                         .bounce = 0.007,
                         .bounce_peak = 0.32,
                         .sway = 0.030,
                         .pelvis_turn = 3.5,
                         .pelvis_drop = 2.5,
                         .chest_turn = 2.5,
                         .lean = 2,
                         .arm_swing = 6,
                         .arm_forward = 2,
                         .arm_spread = 7,
                         .elbow = 19,
                         .elbow_swing = 4,
                         .curl = 7};
  return gait_clip("shuffle", shuffle, stride_pose);
}

}  // namespace throng::mannequin
