#include "assets/mannequin/gait.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <glm/gtc/quaternion.hpp>

namespace throng::mannequin {
namespace {

using glm::dvec3;

constexpr dvec3 heel_from_ankle{0, -0.085, -0.058};
dvec3 ball_from_ankle() {
  const auto& joints = skeleton();
  const dvec3 offset = joints[joint_index("toe.L")].position - joints[joint_index("foot.L")].position;
  return {0, offset.y, offset.z};
}

/// The ankle against the hips' ground point: outwards, up from rest, ahead.
struct FootPlace {
  dvec3 offset;
  double pitch;
};

dvec3 pitched(dvec3 v, double pitch) { return glm::angleAxis(-pitch * degrees, dvec3(1, 0, 0)) * v; }

/// Metres a second over the ground, at least those of a shuffle: who steps on the spot lifts the feet as high.
double lifting_speed(const Gait& gait) { return std::max(0.45, std::hypot(gait.speed, gait.aside)); }

/// The planted foot rolls over the heel's edge and over the ball; the ground runs backwards below the body.
FootPlace planted(const Gait& gait, Side side, double phase) {
  const double pitch = periodic_curve(gait.pitch, phase);
  const dvec3 pivot = pitch > 0 ? heel_from_ankle : ball_from_ankle();
  const dvec3 rolled = pivot - pitched(pivot, pitch);
  const dvec3 gone = stride(gait) * (0.5 * gait.stance - phase);
  const double outward = gait.foot_spread + (side == Side::left ? gone.x : -gone.x);
  const double turn = gait.toe_out * degrees;
  return {{outward + std::sin(turn) * rolled.z, rolled.y, gait.foot_flat + gone.z + std::cos(turn) * rolled.z}, pitch};
}

/// From toe-off to strike, leaving and arriving nearly with the planted foot's velocity, but clear of the ground.
FootPlace swung(const Gait& gait, Side side, double phase) {
  constexpr double h = 1e-5;
  const double span = 1 - gait.stance;
  const dvec3 peel(0, gait.peel * lifting_speed(gait) * span, 0);
  const dvec3 drop(0, -gait.drop * lifting_speed(gait) * span, 0);
  const double t = (phase - gait.stance) / span;
  const dvec3 off = planted(gait, side, gait.stance).offset;
  const dvec3 on = planted(gait, side, 0).offset;
  const dvec3 leaving = (off - planted(gait, side, gait.stance - h).offset) / h * span + peel;
  const dvec3 arriving = (planted(gait, side, h).offset - on) / h * span * dvec3(1, 1, 0.92) + drop;
  dvec3 offset(0, 6.75 * gait.swing_height * t * (1 - t) * (1 - t), 0);
  for (int axis = 0; axis < 3; ++axis) {
    offset[axis] += hermite(off[axis], leaving[axis], on[axis], arriving[axis], t);
  }
  return {offset, periodic_curve(gait.pitch, phase)};
}

/// How much of the foot's pitch the toes take up: all of it on the ground. In the air they straighten until the strike,
/// or, of a foot that comes down on its ball, until the middle of the way.
double toe_share(const Gait& gait, double airborne) {
  const bool lands_on_toes = periodic_curve(gait.pitch, 0) < 0;
  const double straightened = lands_on_toes ? 4 * airborne * (1 - airborne) : airborne;
  return 1 - straightened * straightened;
}

}  // namespace

dvec3 stride(const Gait& gait) {
  return dvec3(gait.aside, 0, gait.speed) * static_cast<double>(gait.frames) / key_rate;
}

void step(Pose& pose, const Gait& gait, Side side, double phase) {
  const double own = phase - std::floor(phase);
  const FootPlace place = own <= gait.stance ? planted(gait, side, own) : swung(gait, side, own);
  const dvec3 rest = skeleton()[joint_index("foot.L")].position;
  const double outward = side == Side::left ? place.offset.x : -place.offset.x;
  const double airborne = std::max(0.0, (own - gait.stance) / (1 - gait.stance));
  const double bend = std::clamp(-place.pitch, 0.0, 55.0) * toe_share(gait, airborne);
  place_leg(pose, side, {{outward, rest.y + place.offset.y, place.offset.z}, place.pitch, gait.toe_out, bend});
}

ArmAngles swinging_arm(const Gait& gait, double phase) {
  // The arm answers the opposite leg, each joint a little later than the one above it.
  const double upper = wave(phase, 0.53);
  const double lower = wave(phase, 0.58);
  const double hand = wave(phase, 0.63);
  return {.flexion = gait.arm_forward + gait.arm_swing * upper,
          .abduction = gait.arm_spread + 1.5 * wave(phase, 0.30, 2),
          .inward_twist = 3 + 5 * wave(phase, 0.56),
          .elbow = gait.elbow + gait.elbow_swing * lower,
          .pronation = 12 + 5 * hand,
          .wrist_flexion = 2 + 5 * wave(phase, 0.65),
          .shrug = 1.2 * wave(phase, 0.35, 2),
          .reach = 3.5 * wave(phase, 0.51)};
}

Pose stride_pose(const Gait& gait, double phase) {
  Pose pose;
  pose.hips = {gait.sway * wave(phase, 0.30), -gait.crouch + gait.bounce * wave(phase, gait.bounce_peak, 2),
               0.006 * wave(phase, 0.20, 2)};
  const double turn = -gait.pelvis_turn * wave(phase, 0.02);
  const double drop = gait.pelvis_drop * wave(phase, 0.17);
  pose["hips"] = turned(0.35 * gait.lean + 0.8 * wave(phase, 0.05, 2), turn, drop);
  const double counter = (gait.chest_turn + gait.pelvis_turn);
  const auto twist = [&](double late) { return counter * wave(phase, 0.03 + late); };
  pose["spine"] = turned(0.25 * gait.lean, 0.25 * twist(0.0), -0.45 * drop);
  pose["chest"] = turned(0.25 * gait.lean + 0.6 * wave(phase, 0.12, 2), 0.35 * twist(0.025),
                         -0.45 * gait.pelvis_drop * wave(phase, 0.195));
  pose["upper_chest"] = turned(0.15 * gait.lean, 0.40 * twist(0.05), -0.35 * gait.pelvis_drop * wave(phase, 0.22));
  steady_head(pose, turned(1.5 + 0.8 * wave(phase, 0.10, 2), 1.2 * wave(phase, 0.10), 0.6 * wave(phase, 0.25)));
  for (const Side side : {Side::left, Side::right}) {
    const double own = side == Side::left ? phase : phase + 0.5;
    place_arm(pose, side, swinging_arm(gait, own));
    curl_fingers(pose, side, [&](double late) { return gait.curl + 4 * wave(own, 0.62 + 0.05 * late); });
    step(pose, gait, side, own);
  }
  return pose;
}

Motion gait_clip(const char* name, const Gait& gait, const std::function<Pose(const Gait& gait, double phase)>& pose) {
  const auto on_its_way = [gait, pose](double phase) {
    Pose posed = pose(gait, phase + first_phase);
    posed.root = stride(gait) * phase;
    return posed;
  };
  return {name,
          gait.frames,
          true,
          on_its_way,
          {{0.5 - first_phase, "footstep_right"}, {1.0 - first_phase, "footstep_left"}}};
}

const Gait& walking() {
  static constexpr Gait walk{
      .frames = 30,
      .speed = 1.35,
      .stance = 0.61,
      .foot_flat = -0.066,
      .foot_spread = 0.072,
      .toe_out = 6,
      .pitch = {{{0.0, 20}, {0.09, 0}, {0.34, 0}, {0.48, -12}, {0.61, -48}, {0.72, -42}, {0.90, 14}}},
      .swing_height = 0.060,
      .crouch = 0.036,
      .bounce = 0.020,
      .bounce_peak = 0.30,
      .sway = 0.018,
      .pelvis_turn = 6.5,
      .pelvis_drop = 3.5,
      .chest_turn = 5.5,
      .lean = 3,
      .arm_swing = 23,
      .arm_forward = 3,
      .arm_spread = 7,
      .elbow = 21,
      .elbow_swing = 12,
      .curl = 7};
  return walk;
}

Motion make_walk() { return gait_clip("walk", walking(), stride_pose); }

Motion make_jog() {
  constexpr Gait jog{.frames = 22,
                     .speed = 2.4,
                     .stance = 0.38,
                     .foot_flat = -0.085,
                     .foot_spread = 0.060,
                     .toe_out = 5,
                     .pitch = {{{0.0, 10}, {0.06, 0}, {0.18, 0}, {0.28, -18}, {0.38, -52}, {0.55, -70}, {0.88, 6}}},
                     .swing_height = 0.20,
                     .crouch = 0.058,
                     .bounce = 0.030,
                     .bounce_peak = 0.43,
                     .sway = 0.010,
                     .pelvis_turn = 7,
                     .pelvis_drop = 4,
                     .chest_turn = 7,
                     .lean = 8,
                     .arm_swing = 28,
                     .arm_forward = -8,
                     .arm_spread = 13,
                     .elbow = 80,
                     .elbow_swing = 12,
                     .curl = 32};
  return gait_clip("jog", jog, stride_pose);
}

Motion make_run() {
  constexpr Gait run{.frames = 20,
                     .speed = 3.6,
                     .stance = 0.30,
                     .foot_flat = -0.095,
                     .foot_spread = 0.050,
                     .toe_out = 4,
                     .pitch = {{{0.0, 6}, {0.05, 0}, {0.12, 0}, {0.21, -20}, {0.30, -54}, {0.50, -80}, {0.86, 6}}},
                     .swing_height = 0.30,
                     .crouch = 0.062,
                     .bounce = 0.034,
                     .bounce_peak = 0.40,
                     .sway = 0.006,
                     .pelvis_turn = 9,
                     .pelvis_drop = 4,
                     .chest_turn = 9,
                     .lean = 13,
                     .arm_swing = 42,
                     .arm_forward = -8,
                     .arm_spread = 12,
                     .elbow = 92,
                     .elbow_swing = 16,
                     .curl = 38};
  return gait_clip("run", run, stride_pose);
}

}  // namespace throng::mannequin
