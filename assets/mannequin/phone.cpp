#include <array>

#include <glm/common.hpp>

#include "assets/mannequin/at_ease.h"
#include "assets/mannequin/clip.h"
#include "assets/mannequin/curve.h"
#include "assets/mannequin/held.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

/// The thumb is on the glass for this share of the time: it taps in bursts, and rests while somebody reads.
constexpr std::array<CurveKey, 6> typing{{{0.02, 0}, {0.08, 1}, {0.34, 1}, {0.40, 0}, {0.62, 0}, {0.90, 0}}};
constexpr std::array<CurveKey, 5> scrolling{{{0.52, 0}, {0.58, 1}, {0.76, 1}, {0.82, 0}, {0.99, 0}}};

double thumb_curl(double phase) {
  return 26 + 9 * periodic_curve(typing, phase) * wave(phase, 0.01, 23) +
         8 * periodic_curve(scrolling, phase) * wave(phase, 0.03, 5);
}

/// Stands and looks at a phone in the right hand. Now and then the weight shifts and the eyes follow a line.
Pose look_at_phone(double phase) {
  Pose pose = stand_at_ease(phase, 2);
  pose["chest"] = pose["chest"] * turned(2.5, 0.6 * wave(phase, 0.37), 0);
  pose["upper_chest"] = pose["upper_chest"] * turned(4.0 + 0.5 * wave(phase, 0.55, 2), -1.0, 0);
  const double reading = wave(phase, 0.08, 4);
  steady_head(pose, turned(27 + 1.2 * wave(phase, 0.62) + 0.6 * wave(phase, 0.11, 3), -5 + 1.5 * wave(phase, 0.2, 2),
                           1.5 + 1.2 * wave(phase, 0.45)));
  pose["eye.L"] = pose["eye.R"] = turned(15 + 2 * wave(phase, 0.3, 3), -1 + 3 * reading, 0);
  ArmAngles free = hanging(phase, 0);
  free.abduction += 3;
  free.flexion -= 3;
  place_arm(pose, Side::left, free);
  hold_phone(pose, phase);
  curl_finger(pose, Side::right, 0, thumb_curl(phase));
  return pose;
}

/// When somebody on the phone speaks, and when they listen.
constexpr std::array<CurveKey, 6> speaking{{{0.05, 1}, {0.38, 1}, {0.44, 0}, {0.66, 0}, {0.72, 1}, {0.86, 0.8}}};

/// A phone at the right ear.
Pose call(double phase) {
  Pose pose = stand_at_ease(phase, 2);
  const double speaks = periodic_curve(speaking, phase);
  const double nod = wave(phase, 0.06, 7) * speaks + 1.4 * wave(phase, 0.5, 5) * (1 - speaks);
  pose["hips"] = pose["hips"] * turned(0, 3 * wave(phase, 0.55), 0);
  pose["chest"] = pose["chest"] * turned(0.4 * wave(phase, 0.08, 7), 3 * wave(phase, 0.58), 0.6);
  pose["upper_chest"] = pose["upper_chest"] * turned(0.5 * nod, 2.5 * wave(phase, 0.61), 0.8);
  steady_head(pose, turned(4 + 1.3 * nod + 2 * wave(phase, 0.2), 9 * wave(phase, 0.6) + 3 * wave(phase, 0.3, 2),
                           7 + 1.3 * wave(phase, 0.45)));
  pose["eye.L"] = pose["eye.R"] = turned(5 + 3 * wave(phase, 0.75), 8 * wave(phase, 0.52) + 5 * wave(phase, 0.1, 2), 0);
  pose["jaw"] = turned(speaks * (4.0 - 2.4 * wave(phase, 0.0, 19) - 1.4 * wave(phase, 0.03, 26)), 0, 0);
  place_arm(pose, Side::right, {.shrug = 3 + wave(phase, 0.2, 2), .reach = 4});
  const Carried head(pose, "head");
  place_hand(pose, Side::right,
             {.grip = head.place({-0.108, 1.612, 0.052}),
              .rotation = palm_towards(Side::right, head.way({1, 0.14, -0.22}), head.way({0.04, 0.80, -0.58})),
              .held = phone_in_hand(),
              .elbow = {-0.80, -1, 0.10}});
  grip_phone(pose, phase);
  stand(pose, 0);
  return pose;
}

/// Up before the face, and down again to look at what came of it.
constexpr std::array<CurveKey, 7> raised{
    {{0.03, 0}, {0.17, 1.0}, {0.30, 0.98}, {0.46, 1.0}, {0.60, 0.02}, {0.72, 0}, {0.92, 0}}};
constexpr std::array<CurveKey, 5> released{{{0.28, 0}, {0.325, 1}, {0.35, 1}, {0.40, 0}, {0.9, 0}}};

Pose take_picture(double phase) {
  Pose pose = stand_at_ease(phase, 2);
  const double up = periodic_curve(raised, phase);
  const double late = periodic_curve(raised, phase - 0.02);
  const double click = periodic_curve(released, phase);
  pose["spine"] = pose["spine"] * turned(1.5 - 2.5 * late, 0, 0);
  pose["chest"] = pose["chest"] * turned(2.5 - 3.0 * periodic_curve(raised, phase - 0.03), 0, 0);
  pose["upper_chest"] = pose["upper_chest"] * turned(3.0 - 2.0 * up, 0, 0);
  const double aims = 3 * wave(phase, 0.42) + 1.5 * wave(phase, 0.1, 2);
  steady_head(pose, turned(glm::mix(24.0, 3.0, late) + 0.8 * wave(phase, 0.11, 3), aims, 1.0 * wave(phase, 0.45)));
  pose["eye.L"] = pose["eye.R"] = turned(glm::mix(16.0, 1.0, up), 0.3 * aims, 0);
  const Carried chest(pose, "upper_chest");
  const Carried head(pose, "head");
  const dvec3 low = chest.place({0, 1.235, 0.300});
  const dvec3 high = head.place({0, 1.668 - 0.002 * click, 0.255});
  const dvec3 camera = glm::mix(low, high, up) + chest.way({0, 0, 0.05 * up * (1 - up)});
  const dvec3 facing = glm::mix(chest.way({0, 0.72, -0.69}), head.way({0, 0.02, -1}), up);
  const dvec3 upwards = glm::mix(chest.way({0, 0.69, 0.72}), head.way({0, 1, 0.02}), up);
  for (const Side side : {Side::left, Side::right}) {
    const double out = side == Side::left ? 1 : -1;
    const dvec3 aside = chest.way({out, 0, 0});
    place_arm(pose, side, {.shrug = 2 + 5 * late, .reach = 8});
    place_hand(pose, side,
               {.grip = camera + aside * hand_from_camera,
                .rotation = hand_at_camera(side, aside, facing, upwards),
                .held = camera_in_hand(),
                .elbow = dvec3(out * (0.45 + 0.05 * wave(phase, 0.3)), -1, 0.05)});
    curl_fingers(pose, side, [&](double lateness) { return 24 + 1.5 * wave(phase, 0.2 + 0.1 * lateness); });
  }
  curl_finger(pose, Side::right, 1, 20 + 16 * click);
  stand(pose, 0);
  return pose;
}

}  // namespace

dvec3 camera_in_hand() { return in_hand(0.090, 0.004, 0.034); }

glm::dquat hand_at_camera(Side side, dvec3 out, dvec3 facing, dvec3 upwards) {
  return palm_towards(side, -out * 0.8 + facing * 0.6, upwards * 0.62 - facing * 0.55 - out * 0.55);
}

dvec3 phone_in_hand() { return in_hand(0.088, 0.004, 0.023); }

void grip_phone(Pose& pose, double phase) {
  curl_fingers(pose, Side::right, [&](double late) { return 20 + 1.5 * wave(phase, 0.3 + 0.1 * late); });
  curl_finger(pose, Side::right, 0, 24 + wave(phase, 0.25));
}

void hold_phone(Pose& pose, double phase) {
  place_arm(pose, Side::right, {.shrug = 0.8 * wave(phase, 0.20, 2), .reach = 5});
  const Carried chest(pose, "upper_chest");
  const dvec3 grip = chest.place({-0.085, 1.285 + 0.006 * wave(phase, 0.33), 0.315 + 0.005 * wave(phase, 0.5)});
  place_hand(pose, Side::right,
             {.grip = grip,
              .rotation = palm_towards(Side::right, chest.way({0.20, 0.72, -0.66}), chest.way({0.46, 0.52, 0.70})),
              .held = phone_in_hand(),
              .elbow = {-0.55, -1, -0.35}});
  grip_phone(pose, phase);
}

Motion make_phone() { return {"phone", 180, true, look_at_phone}; }
Motion make_call() { return {"call", 180, true, call}; }
Motion make_take_picture() { return {"take picture", 180, true, take_picture}; }

}  // namespace throng::mannequin
