#include <algorithm>
#include <array>

#include "assets/mannequin/at_ease.h"
#include "assets/mannequin/clip.h"
#include "assets/mannequin/curve.h"

namespace throng::mannequin {
namespace {

/// Where somebody looks who looks around, degrees to the left.
constexpr std::array<CurveKey, 8> gaze{
    {{0.0, 4}, {0.10, 4}, {0.20, 58}, {0.37, 50}, {0.52, -60}, {0.70, -52}, {0.82, -8}, {0.90, 4}}};
constexpr std::array<CurveKey, 5> gaze_up{{{0.0, 1}, {0.22, -4}, {0.38, 3}, {0.55, -7}, {0.78, 3}}};

/// Eyes first, then the head, then shoulders and hips, each less far.
Pose look_around(double phase) {
  Pose pose = stand_at_ease(phase, 2);
  const double eyes = periodic_curve(gaze, phase);
  const double head = periodic_curve(gaze, phase - 0.025);
  const double chest = periodic_curve(gaze, phase - 0.045);
  const double hips = periodic_curve(gaze, phase - 0.065);
  pose["hips"] = turned(0, 0.07 * hips, 0) * pose["hips"];
  pose["spine"] = pose["spine"] * turned(0, 0.05 * periodic_curve(gaze, phase - 0.055), 0);
  pose["chest"] = pose["chest"] * turned(0, 0.10 * chest, -0.012 * chest);
  pose["upper_chest"] = pose["upper_chest"] * turned(0, 0.13 * periodic_curve(gaze, phase - 0.037), 0);
  steady_head(
      pose, turned(1.5 + periodic_curve(gaze_up, phase - 0.02), 0.86 * head, -0.035 * head + 1.2 * wave(phase, 0.45)));
  const double aside = std::clamp(eyes - 0.86 * head, -24.0, 24.0);
  pose["eye.L"] = pose["eye.R"] = turned(periodic_curve(gaze_up, phase + 0.01) * 0.6, aside, 0);
  stand(pose, 0);
  return pose;
}

/// When each hand speaks along.
constexpr std::array<CurveKey, 6> right_hand{
    {{0.02, 0}, {0.12, 1}, {0.30, 0.85}, {0.42, 1.0}, {0.56, 0.05}, {0.90, 0}}};
constexpr std::array<CurveKey, 5> left_hand{{{0.44, 0}, {0.56, 1}, {0.70, 0.7}, {0.84, 0.02}, {0.95, 0}}};

void talk_with(Pose& pose, Side side, double phase) {
  const auto raised = [&](double late) {
    return side == Side::right ? periodic_curve(right_hand, phase - late) : periodic_curve(left_hand, phase - late);
  };
  const double beat = wave(phase, side == Side::right ? 0.05 : 0.02, 7);
  const double late_beat = wave(phase, side == Side::right ? 0.07 : 0.04, 7);
  const ArmAngles down = hanging(side == Side::left ? phase : phase + 0.5, side == Side::left ? 0.0 : 0.06);
  ArmAngles up{.flexion = 20 + 3 * beat,
               .abduction = 15 + 2 * wave(phase, 0.3, 3),
               .inward_twist = 10 + 5 * wave(phase, 0.15, 3),
               .elbow = 84 + 8 * late_beat,
               .pronation = -42 + 16 * wave(phase, 0.2, 3),
               .wrist_flexion = -4 + 9 * wave(phase, side == Side::right ? 0.09 : 0.06, 7),
               .shrug = 3,
               .reach = 4};
  ArmAngles arm = mix(down, up, raised(0.0));
  arm.elbow = mix(down, up, raised(0.012)).elbow;
  arm.pronation = mix(down, up, raised(0.022)).pronation;
  place_arm(pose, side, arm);
  curl_fingers(pose, side,
               [&](double late) { return 7 + 7 * raised(0.03 + 0.02 * late) * wave(phase, 0.08 + 0.02 * late, 7); });
}

Pose talk(double phase) {
  Pose pose = stand_at_ease(phase, 2);
  const double nod = wave(phase, 0.06, 7) * (0.6 + 0.4 * wave(phase, 0.2)) + 0.7 * wave(phase, 0.3, 3);
  pose["chest"] = pose["chest"] * turned(0.5 * wave(phase, 0.08, 7), 2.0 * wave(phase, 0.32, 2), 0);
  pose["upper_chest"] =
      pose["upper_chest"] * turned(0.4 * wave(phase, 0.09, 7), 2.4 * wave(phase, 0.34, 2), 0.6 * wave(phase, 0.5, 3));
  steady_head(pose, turned(1.5 + 2.4 * nod, 6 * wave(phase, 0.36, 2) + 3 * wave(phase, 0.1),
                           2.4 * wave(phase, 0.60) + 1.3 * wave(phase, 0.2, 3)));
  pose["eye.L"] = pose["eye.R"] = turned(1.5 * wave(phase, 0.55), 3 * wave(phase, 0.02, 2), 0);
  // Syllables: quicker than the beats of the hands and of uneven strength, with a pause for breath.
  const double words = std::clamp(0.75 + 0.5 * wave(phase, 0.35) + 0.35 * wave(phase, 0.55, 3), 0.0, 1.0);
  pose["jaw"] = turned(words * (4.2 - 2.6 * wave(phase, 0.0, 19) - 1.4 * wave(phase, 0.03, 26)), 0, 0);
  for (const Side side : {Side::left, Side::right}) talk_with(pose, side, phase);
  stand(pose, 0);
  return pose;
}

}  // namespace

Motion make_look_around() { return {"look around", 180, true, look_around}; }
Motion make_talk() { return {"talk", 180, true, talk}; }

}  // namespace throng::mannequin
