#include <array>

#include <glm/common.hpp>

#include "assets/mannequin/curve.h"
#include "assets/mannequin/gait.h"

namespace throng::mannequin {
namespace {

constexpr std::size_t frames = 48;
constexpr double seconds = frames / key_rate;

/// The phase of the walk at a time: the right foot catches on something, the body waits for it, then hurries after.
/// The root goes with the phase, so that planted feet stay where they are.
double walked(double time) {
  constexpr std::array<CurveKey, 8> phases{{{0.0, 0.25},
                                            {0.10, 0.345},
                                            {0.22, 0.40},
                                            {0.36, 0.455},
                                            {0.50, 0.585},
                                            {0.80, 1.01},
                                            {1.10, 1.345},
                                            {seconds, 1.75}}};
  return open_curve(phases, time);
}

double time_of(double phase) {
  double low = 0;
  double high = seconds;
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (low + high);
    (walked(middle) < phase ? low : high) = middle;
  }
  return low;
}

/// Rises and falls smoothly between four times.
double swell(double time, double from, double full, double until, double over) {
  const std::array<CurveKey, 6> keys{{{from - 1, 0}, {from, 0}, {full, 1}, {until, 1}, {over, 0}, {over + 1, 0}}};
  return open_curve(keys, time);
}

void throw_arm(Pose& pose, Side side, double phase, double time) {
  const double late = side == Side::left ? 0.0 : 0.07;
  const double thrown = swell(time - late, 0.08, 0.36, 0.55, 1.35);
  const double lower = swell(time - late, 0.10, 0.42, 0.52, 1.25);
  const ArmAngles swing = swinging_arm(walking(), phase);
  ArmAngles out{.flexion = side == Side::left ? 62.0 : 40.0,
                .abduction = side == Side::left ? 34.0 : 48.0,
                .inward_twist = -6,
                .elbow = 58,
                .pronation = 48,
                .wrist_flexion = -28,
                .shrug = 11,
                .reach = 9};
  ArmAngles angles = mix(swing, out, thrown);
  const ArmAngles hand = mix(swing, out, lower);
  angles.elbow = hand.elbow;
  angles.wrist_flexion = hand.wrist_flexion;
  place_arm(pose, side, angles);
  curl_fingers(pose, side, [&](double spread) {
    return glm::mix(walking().curl + 4 * wave(phase, 0.62 + 0.05 * spread), -9.0,
                    swell(time - 0.06 * spread, 0.1, 0.35, 0.6, 1.2));
  });
}

Pose trip(double share) {
  const double time = share * seconds;
  const double phase = walked(time);
  Pose pose = stride_pose(walking(), phase);
  const double fall = swell(time, 0.10, 0.44, 0.48, 1.25);
  const double late_fall = swell(time, 0.14, 0.50, 0.54, 1.35);
  pose.hips += glm::dvec3(0.010 * late_fall, -0.055 * swell(time, 0.22, 0.62, 0.68, 1.2),
                          0.105 * swell(time, 0.06, 0.40, 0.46, 1.0));
  pose["hips"] = turned(13 * fall, 0, 0) * pose["hips"];
  pose["spine"] = pose["spine"] * turned(7 * fall, 0, 2.0 * late_fall);
  pose["chest"] = pose["chest"] * turned(8 * late_fall, -3 * late_fall, 0);
  pose["upper_chest"] = pose["upper_chest"] * turned(5 * swell(time, 0.18, 0.54, 0.60, 1.4), -3 * fall, 0);
  // First at the ground, then back to where it went.
  const double down = swell(time, 0.16, 0.50, 0.78, 1.45);
  steady_head(pose, turned(1.5 + 0.8 * wave(phase, 0.10, 2) + 24 * down, 1.2 * wave(phase, 0.10) - 5 * down,
                           0.6 * wave(phase, 0.25) + 2 * late_fall));
  pose["jaw"] = turned(7 * swell(time, 0.16, 0.34, 0.50, 1.0), 0, 0);
  for (const Side side : {Side::left, Side::right}) {
    const double own = side == Side::left ? phase : phase + 0.5;
    throw_arm(pose, side, own, time);
    step(pose, walking(), side, own);
  }
  pose.root = stride(walking()) * (phase - first_phase);
  return pose;
}

}  // namespace

Motion make_stumble() {
  const auto at = [](double phase) { return time_of(phase) / seconds; };
  return {"stumble",
          frames,
          false,
          trip,
          {{at(0.5), "footstep_right"}, {at(1.0), "footstep_left"}, {at(1.5), "footstep_right"}}};
}

}  // namespace throng::mannequin
