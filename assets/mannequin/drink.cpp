#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/at_ease.h"
#include "assets/mannequin/clip.h"
#include "assets/mannequin/curve.h"
#include "assets/mannequin/held.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

/// The way of the cup from the belly to the mouth, and how far it is tipped there.
constexpr std::array<CurveKey, 7> lifted{
    {{0.05, 0}, {0.30, 0}, {0.46, 1}, {0.55, 1}, {0.62, 0.985}, {0.77, 0.0}, {0.9, 0.0}}};
constexpr std::array<CurveKey, 6> tipped{{{0.05, 0}, {0.40, 0}, {0.50, 1}, {0.57, 1}, {0.64, 0}, {0.9, 0}}};

HandTarget before_the_belly(const Pose& pose, double phase) {
  const Carried chest(pose, "upper_chest");
  return {.grip = chest.place({-0.150, 1.165 + 0.008 * wave(phase, 0.3), 0.285 + 0.006 * wave(phase, 0.1)}),
          .rotation = thumb_towards(Side::right, dvec3(0.05, 1, 0.06), chest.way({0.86, 0, -0.50})),
          .held = cup_in_hand(),
          .elbow = {-0.42, -1, -0.45}};
}

/// The rim at the lips: the further the cup is tipped, the further its middle is before the mouth.
HandTarget at_the_mouth(const Pose& pose, double tip) {
  const Carried head(pose, "head");
  const double turn = (12 + 36 * tip) * degrees;
  const dvec3 axis(0, std::cos(turn), -std::sin(turn));
  const dvec3 away(0, std::sin(turn), std::cos(turn));
  constexpr dvec3 lips{0, 1.604, 0.102};
  constexpr double half_height = 0.055;
  constexpr double radius = 0.038;
  return {.grip = head.place(lips - axis * (half_height - 0.004) + away * radius),
          .rotation = thumb_towards(Side::right, head.way(axis), head.way({0.46, -0.62, -0.66})),
          .held = cup_in_hand(),
          .elbow = {-0.74, -1, 0.05}};
}

/// Holds a cup and drinks once a cycle; the free hand rests.
Pose drink(double phase) {
  Pose pose = stand_at_ease(phase, 2);
  const double up = periodic_curve(lifted, phase);
  const double late = periodic_curve(lifted, phase - 0.02);
  const double tip = periodic_curve(tipped, phase);
  const double drunk = periodic_curve(tipped, phase - 0.012);
  pose["chest"] = pose["chest"] * turned(0.8 * (1 - late), -1.5 * late, 0);
  pose["upper_chest"] = pose["upper_chest"] * turned(1.0 - 3.0 * drunk, -2.0 * up, 0);
  const double looks = (1 - up) * (10 * wave(phase, 0.12) + 4 * wave(phase, 0.35, 2));
  steady_head(pose, turned(2 + 4.0 * late * (1 - drunk) - 13 * drunk, looks, (1 - up) * 1.6 * wave(phase, 0.45)));
  pose["eye.L"] = pose["eye.R"] = turned(6 * late + 6 * drunk + 1.5 * wave(phase, 0.55), 0.8 * looks, 0);
  pose["jaw"] = turned(3.5 * drunk, 0, 0);
  place_arm(pose, Side::right, {.shrug = 1 + 5 * late, .reach = 4 + 2 * up});
  HandTarget hand = mix(before_the_belly(pose, phase), at_the_mouth(pose, tip), up);
  hand.grip += Carried(pose, "upper_chest").way({0, 0, 0.16 * up * (1 - up)});
  place_hand(pose, Side::right, hand);
  curl_fingers(pose, Side::right, [&](double lateness) { return 33 + 1.2 * wave(phase, 0.3 + 0.1 * lateness); });
  curl_finger(pose, Side::right, 0, 8 + wave(phase, 0.35));
  stand(pose, 0);
  return pose;
}

}  // namespace

dvec3 cup_in_hand() { return in_hand(0.078, 0.0, 0.055); }

Motion make_drink() { return {"drink", 240, true, drink}; }

}  // namespace throng::mannequin
