#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>

#include "assets/mannequin/at_ease.h"
#include "assets/mannequin/clip.h"
#include "assets/mannequin/curve.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

constexpr double quarter = 90;  ///< Degrees that a clip turns.
constexpr double toe_out = 9;

/// One step of a turn to the left: when the foot is in the air, and how far it has turned when it lands.
struct TurningStep {
  Side side;
  double off, on;
  double yaw;  ///< Degrees.
};
/// The inner foot opens, the outer one follows around it, the inner one closes.
constexpr std::array<TurningStep, 3> turning_steps{
    {{Side::left, 0.10, 0.36, 48}, {Side::right, 0.38, 0.66, quarter}, {Side::left, 0.68, 0.92, quarter}}};

double smooth(double t) { return t * t * t * (10 + t * (6 * t - 15)); }

/// Where a foot stands when the body has turned so far about the origin.
dvec3 standing_place(Side side, double yaw) {
  const dvec3 ankle = skeleton()[joint_index(side == Side::left ? "foot.L" : "foot.R")].position;
  return glm::angleAxis(yaw * degrees, dvec3(0, 1, 0)) * ankle;
}

struct TurningFoot {
  dvec3 ankle;
  double yaw, pitch;
};

TurningFoot foot_at(Side side, double phase) {
  double yaw = 0;
  for (const TurningStep& step : turning_steps) {
    if (step.side != side || phase < step.off) continue;
    const double t = std::min(1.0, (phase - step.off) / (step.on - step.off));
    if (t == 1.0) {
      yaw = step.yaw;
      continue;
    }
    // Up quickly, down gently, and turned before it comes down.
    const double lift = 27.0 / 4.0 * t * (1 - t) * (1 - t);
    const double aside = smooth(std::clamp((t - 0.10) / 0.80, 0.0, 1.0));
    dvec3 place = glm::mix(standing_place(side, yaw), standing_place(side, step.yaw), aside);
    place.y +=
        0.050 * lift * std::min(1.0, 4 * t) + 0.012 * std::sin(std::numbers::pi * t) * std::sin(std::numbers::pi * t);
    return {place, yaw + (step.yaw - yaw) * aside, -16 * lift * std::min(1.0, 3 * t)};
  }
  return {standing_place(side, yaw), yaw, 0};
}

/// Degrees turned, smooth from end to end, `ahead` in phase of the root.
double turned_by(double phase, double ahead) {
  const double from = std::max(0.0, 0.04 - ahead);
  const double t = std::clamp((phase - from) / (0.90 - from - ahead), 0.0, 1.0);
  return quarter * smooth(t);
}

Pose turn_left(double phase) {
  Pose pose = stand_at_ease(phase, 1);
  // Over the foot that stands: to the right first, then to the left, then back.
  constexpr std::array<CurveKey, 6> weight{
      {{0.0, 0.0}, {0.20, -1.0}, {0.34, -0.6}, {0.54, 1.0}, {0.66, 0.6}, {0.82, -0.8}}};
  const double root = turned_by(phase, 0);
  pose["root"] = turned(0, root, 0);
  const double lean = periodic_curve(weight, phase);
  const double late_lean = periodic_curve(weight, phase - 0.03);
  pose.hips.x = 0.030 * lean;
  pose.hips.y -= 0.012 + 0.008 * wave(phase, 0.35, 3);
  const double hips = turned_by(phase, -0.01) - root;
  const double chest = turned_by(phase, 0.08) - root;
  const double head = turned_by(phase, 0.20) - root;
  pose["hips"] = pose["hips"] * turned(1.0, hips, 1.6 * lean);
  pose["spine"] = pose["spine"] * turned(0, 0.3 * (chest - hips), -0.8 * late_lean);
  pose["chest"] = pose["chest"] * turned(0.6, 0.35 * (chest - hips), -0.8 * periodic_curve(weight, phase - 0.05));
  pose["upper_chest"] =
      pose["upper_chest"] * turned(0, 0.35 * (chest - hips), -0.4 * periodic_curve(weight, phase - 0.07));
  steady_head(pose, turned(0, root + head, 0) * turned(2.5 + wave(phase, 0.7), 0, 1.0 * late_lean));
  const double gaze = std::clamp(0.5 * (turned_by(phase, 0.26) - turned_by(phase, 0.20)), 0.0, 18.0);
  pose["eye.L"] = pose["eye.R"] = turned(0, gaze, 0);
  // The arms stay behind as the shoulders turn.
  const double drag = turned_by(phase, 0.02) - turned_by(phase, -0.06);
  for (const Side side : {Side::left, Side::right}) {
    const double sign = side == Side::left ? -1 : 1;
    ArmAngles arm = hanging(phase, side == Side::left ? 0.0 : 0.06);
    arm.flexion += sign * 0.55 * drag;
    arm.abduction += 3 + 0.10 * drag;
    arm.elbow += 4 + 0.25 * (turned_by(phase, -0.02) - turned_by(phase, -0.10));
    place_arm(pose, side, arm);
    const TurningFoot foot = foot_at(side, phase);
    const double outward = side == Side::left ? toe_out + foot.yaw : toe_out - foot.yaw;
    place_leg(pose, side, {foot.ankle, foot.pitch, outward, std::max(0.0, -0.7 * foot.pitch)});
  }
  return pose;
}

/// The same body in a mirror.
Pose mirrored(const Pose& pose) {
  Pose other = pose;
  other.root.x = -pose.root.x;
  other.hips.x = -pose.hips.x;
  for (std::size_t joint = 0; joint < joint_count; ++joint) {
    const glm::dquat q = pose.rotations[mirrored_joint(joint)];
    other.rotations[joint] = {q.w, q.x, -q.y, -q.z};
  }
  return other;
}

}  // namespace

Motion make_turn(Side towards) {
  Motion motion{towards == Side::left ? "turn left" : "turn right", 48, true, turn_left};
  if (towards == Side::right) motion.pose = [](double phase) { return mirrored(turn_left(phase)); };
  for (const TurningStep& step : turning_steps) {
    motion.marks.push_back(
        {step.on, (step.side == Side::left) == (towards == Side::left) ? "footstep_left" : "footstep_right"});
  }
  return motion;
}

}  // namespace throng::mannequin
