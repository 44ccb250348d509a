#include "assets/mannequin/held.h"

#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/at_ease.h"
#include "assets/mannequin/clip.h"
#include "assets/mannequin/curve.h"
#include "assets/mannequin/gait.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

void close_fist(Pose& pose, Side side, double phase, double curl) {
  curl_fingers(pose, side, [&](double late) { return curl + 1.2 * wave(phase, 0.3 + 0.1 * late); });
  curl_finger(pose, side, 0, 0.5 * curl + wave(phase, 0.25));
}

/// The arm hangs, away from what it holds, and hardly swings.
Pose carry(double phase) {
  Pose pose = stand_at_ease(phase, 1);
  place_arm(pose, Side::right,
            {.flexion = 2 + 1.0 * wave(phase, 0.30),
             .abduction = 10 + 0.6 * wave(phase, 0.22, 2),
             .inward_twist = 2 + wave(phase, 0.40),
             .elbow = 9 + 1.0 * wave(phase, 0.36),
             .pronation = 6 + wave(phase, 0.45),
             .wrist_flexion = 4 + 0.8 * wave(phase, 0.50),
             .shrug = -1.5 + 0.9 * wave(phase, 0.20, 2),
             .reach = 1.0 + 0.7 * wave(phase, 0.24, 2)});
  close_fist(pose, Side::right, phase, 66);
  return pose;
}

/// The right forearm is up and the fist holds something upright.
Pose hold_up(double phase) {
  Pose pose = stand_at_ease(phase, 1);
  place_arm(pose, Side::right, {.shrug = 2 + 0.9 * wave(phase, 0.20, 2), .reach = 4 + 0.7 * wave(phase, 0.24, 2)});
  const Carried chest(pose, "upper_chest");
  place_hand(pose, Side::right,
             {.grip = chest.place({-0.165, 1.275 + 0.006 * wave(phase, 0.3), 0.235 + 0.006 * wave(phase, 0.4)}),
              .rotation = thumb_towards(Side::right, dvec3(0.02 + 0.015 * wave(phase, 0.35), 1, -0.10),
                                        chest.way({0.80, 0, -0.45})),
              .held = handle_in_hand(),
              .elbow = {-0.42, -1, -0.30}});
  close_fist(pose, Side::right, phase, 64);
  return pose;
}

/// A phone before the chest, the head bent to it.
Pose walk_with_phone(double phase) {
  Pose pose = stand_at_ease(phase, 1);
  steady_head(pose, turned(21 + wave(phase, 0.62), -4 + 1.2 * wave(phase, 0.2, 2), 1 + wave(phase, 0.45)));
  pose["eye.L"] = pose["eye.R"] = turned(17 + 2 * wave(phase, 0.3, 3), -1 + 2.5 * wave(phase, 0.08, 4), 0);
  hold_phone(pose, phase);
  return pose;
}

/// The left hand hangs a little out and back for a child's.
Pose lead(double phase) {
  Pose pose = stand_at_ease(phase, 1);
  place_arm(pose, Side::left,
            {.flexion = 4 + 2.0 * wave(phase, 0.30, 2),
             .abduction = 20 + 0.8 * wave(phase, 0.22, 2),
             .inward_twist = 12 + wave(phase, 0.40),
             .elbow = 30 + 2.0 * wave(phase, 0.36, 2),
             .pronation = 52 + 2 * wave(phase, 0.45),
             .wrist_flexion = 10 + wave(phase, 0.50),
             .shrug = -1 + 0.9 * wave(phase, 0.20, 2),
             .reach = 1.0 + 0.7 * wave(phase, 0.24, 2)});
  close_fist(pose, Side::left, phase, 34);
  return pose;
}

/// The right hand is up to that of somebody taller.
Pose led(double phase) {
  Pose pose = stand_at_ease(phase, 1);
  place_arm(pose, Side::right, {.shrug = 14 + wave(phase, 0.20, 2), .reach = 3 + 0.7 * wave(phase, 0.24, 2)});
  const Carried chest(pose, "upper_chest");
  const dvec3 hand(-0.530 + 0.006 * wave(phase, 0.3), 1.520 + 0.010 * wave(phase, 0.45, 2),
                   0.085 + 0.020 * wave(phase, 0.33, 2));
  place_hand(pose, Side::right,
             {.grip = chest.place(hand),
              .rotation = palm_towards(Side::right, chest.way({0.15, 0.15, 1}), chest.way({-0.55, 1, -0.10})),
              .held = in_hand(palm_along, 0, 0.024),
              .elbow = chest.way({-0.55, -0.75, -0.10})});
  close_fist(pose, Side::right, phase, 42);
  return pose;
}

/// Both hands on a bar that rolls on evenly before the walker.
Pose push(double phase) {
  Pose pose = stride_pose(walking(), phase);
  for (const Side side : {Side::left, Side::right}) {
    const double out = side == Side::left ? 1 : -1;
    place_arm(pose, side, {.shrug = -1 + 0.8 * wave(phase, 0.2, 2), .reach = 8 + out * 1.2 * wave(phase, 0.06)});
    place_hand(pose, side,
               {.grip = {out * 0.185, bar_height, bar_ahead},
                .rotation = thumb_towards(side, dvec3(-out, 0.10, 0.12), dvec3(0, -1, -0.30)),
                .held = handle_in_hand(),
                .elbow = {out * 0.75, -1, -0.40 + 0.05 * wave(phase, side == Side::left ? 0.2 : 0.7)}});
    close_fist(pose, side, phase, 58);
  }
  return pose;
}

/// The stick of the right hand goes with the left foot: where its tip is, and where the hand is, from the root.
struct StickPlace {
  double tip, tip_height, hand;
};

StickPlace stick_place(double phase) {
  constexpr double landed = 0.36;
  constexpr double on_the_ground = 0.56;
  constexpr double foremost = 0.235, hindmost = -0.085;
  const double speed = walking().speed * static_cast<double>(walking().frames) / key_rate;
  const double own = phase - std::floor(phase);
  StickPlace place{};
  constexpr std::array<CurveKey, 2> hand{{{0.52, hindmost}, {0.98, foremost}}};
  place.hand = periodic_curve(hand, own);
  if (own <= on_the_ground) {
    place.tip = landed - speed * own;
    return place;
  }
  const double span = 1 - on_the_ground;
  const double t = (own - on_the_ground) / span;
  place.tip = hermite(landed - speed * on_the_ground, -speed * span, landed, -speed * span, t);
  place.tip_height = 16 * 0.060 * t * t * (1 - t) * (1 - t);
  return place;
}

/// A walking stick in the right hand touches the ground together with the left foot.
Pose walk_with_stick(double phase) {
  Pose pose = stride_pose(walking(), phase);
  const StickPlace place = stick_place(phase);
  const double beside = -0.285;
  const double reached = place.tip - place.hand;
  const double height = place.tip_height + std::sqrt(stick_length * stick_length - reached * reached);
  const dvec3 hand(beside, height, place.hand);
  const dvec3 tip(beside, place.tip_height, place.tip);
  place_arm(pose, Side::right, {.shrug = 1 + wave(phase, 0.3), .reach = 2 + 3 * wave(phase, 0.98)});
  place_hand(pose, Side::right,
             {.grip = hand,
              .rotation = fingers_towards(Side::right, tip - hand, dvec3(1, 0, 0.10)),
              .held = handle_in_hand(),
              .elbow = {-0.50, -0.25, -1}});
  close_fist(pose, Side::right, phase, 62);
  return pose;
}

}  // namespace

dvec3 handle_in_hand() { return in_hand(palm_along, 0.0, 0.029); }

Motion make_carry() { return {"carry", 90, true, carry}; }
Motion make_hold_up() { return {"hold up", 90, true, hold_up}; }
Motion make_hold_phone() { return {"hold phone", 90, true, walk_with_phone}; }
Motion make_lead() { return {"lead", 90, true, lead}; }
Motion make_led() { return {"led", 90, true, led}; }
Motion make_push() {
  return gait_clip("push", walking(), [](const Gait&, double phase) { return push(phase); });
}
Motion make_stick() {
  return gait_clip("stick", walking(), [](const Gait&, double phase) { return walk_with_stick(phase); });
}

}  // namespace throng::mannequin
