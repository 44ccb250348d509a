#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/at_ease.h"
#include "assets/mannequin/clip.h"
#include "assets/mannequin/curve.h"
#include "assets/mannequin/reach.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

/// Against a wall 0.24 m behind the root, the right sole on the wall.
Pose lean(double phase) {
  Pose pose;
  const double breath = wave(phase, 0.20, 2);
  pose.hips = {0.010 + 0.004 * wave(phase, 0.25), -0.048 + 0.001 * breath, -0.062 + 0.002 * wave(phase, 0.1)};
  pose["hips"] = turned(-7 + 0.3 * wave(phase, 0.6), 2 + 0.8 * wave(phase, 0.3), -1.5 + 0.5 * wave(phase, 0.25));
  pose["spine"] = turned(-1 - 0.4 * breath, -0.6 * wave(phase, 0.33), 0.8 - 0.4 * wave(phase, 0.27));
  pose["chest"] = turned(1.5 - 0.9 * wave(phase, 0.22, 2), -1 - 0.5 * wave(phase, 0.36), 0.5 - 0.4 * wave(phase, 0.29));
  pose["upper_chest"] = turned(3 - 0.8 * wave(phase, 0.24, 2), -1 - 0.4 * wave(phase, 0.40), 0);
  const double gaze = 16 * wave(phase, 0.42) + 6 * wave(phase, 0.1, 2);
  steady_head(pose, turned(2 + 1.5 * wave(phase, 0.70), gaze, 1.4 * wave(phase, 0.5)));
  pose["eye.L"] = pose["eye.R"] = turned(1.5 * wave(phase, 0.55), 7 * wave(phase, 0.36) + 3 * wave(phase, 0.05, 2), 0);
  place_leg(pose, Side::left, {{0.098, 0.085, 0.100}, 0, 11, 0});
  place_leg(pose, Side::right, {{-0.112, 0.385, -0.128}, -72, 2, 16 + wave(phase, 0.35)});
  place_arm(pose, Side::left,
            {.flexion = 9 + 0.8 * wave(phase, 0.30),
             .abduction = 9 + 0.5 * wave(phase, 0.22, 2),
             .inward_twist = 10 + wave(phase, 0.40),
             .elbow = 14 + wave(phase, 0.36),
             .pronation = 24 + wave(phase, 0.45),
             .wrist_flexion = 4 + wave(phase, 0.5),
             .shrug = 1 + 0.9 * wave(phase, 0.20, 2),
             .reach = 2 + 0.7 * wave(phase, 0.24, 2)});
  place_arm(pose, Side::right, {.shrug = 1 + 0.9 * wave(phase, 0.22, 2), .reach = 3 + 0.7 * wave(phase, 0.26, 2)});
  const Carried thigh(pose, "thigh.R");
  place_hand(pose, Side::right,
             {.grip = thigh.place({-0.140, 0.772, 0.122}),
              .rotation = palm_towards(Side::right, thigh.way({0.10, 0, -1}), thigh.way({0.35, -1, 0})),
              .held = in_hand(0.060, 0, 0.020),
              .elbow = {-1.0, 0.1, -0.10 + 0.03 * wave(phase, 0.3)}});
  for (const Side side : {Side::left, Side::right}) {
    curl_fingers(pose, side, [&](double late) {
      return (side == Side::left ? 9 : 5) + 2 * wave(phase, (side == Side::left ? 0.3 : 0.7) + 0.08 * late);
    });
  }
  return pose;
}

constexpr double step_height = 0.32;      ///< Of the seat.
constexpr double seat_above = 0.105;      ///< Of the hips above what they sit on.
constexpr double elbow_on_thigh = 0.126;  ///< From the thigh's bone to the elbow's, with clothes between them.

/// Returns the place on a line that is so far from a point, or the nearest to that; the farther one along `way`.
dvec3 along_line(dvec3 from, dvec3 way, dvec3 point, double distance) {
  const dvec3 offset = from - point;
  const double middle = -glm::dot(way, offset);
  const double square = middle * middle - glm::dot(offset, offset) + distance * distance;
  return from + way * (middle + std::sqrt(std::max(square, 0.0)));
}

/// On a step 0.32 m high, the elbows on the thighs and the hands before the shins.
Pose sit_on_step(double phase) {
  Pose pose;
  const double breath = wave(phase, 0.20, 2);
  const double hip_height = skeleton()[joint_index("hips")].position.y;
  pose.hips = {0.005 * wave(phase, 0.25), step_height + seat_above - hip_height + 0.001 * breath,
               -0.375 + 0.003 * wave(phase, 0.1)};
  pose["hips"] = turned(9.5 + 0.5 * wave(phase, 0.6), 0.8 * wave(phase, 0.3), 0.6 * wave(phase, 0.25));
  pose["spine"] = turned(11 - 0.4 * breath, 1.0 * wave(phase, 0.34), -0.5 * wave(phase, 0.27));
  pose["chest"] = turned(10 - 0.7 * wave(phase, 0.22, 2), 1.0 * wave(phase, 0.37), -0.5 * wave(phase, 0.30));
  pose["upper_chest"] = turned(7 - 0.6 * wave(phase, 0.24, 2), 0.8 * wave(phase, 0.40), -0.3 * wave(phase, 0.33));
  const double gaze = 14 * wave(phase, 0.44) + 5 * wave(phase, 0.15, 2);
  steady_head(pose, turned(7 + 2.0 * wave(phase, 0.70), gaze, 1.4 * wave(phase, 0.50)));
  pose["eye.L"] = pose["eye.R"] = turned(2 + 2 * wave(phase, 0.55), 8 * wave(phase, 0.38), 0);
  for (const Side side : {Side::left, Side::right}) {
    const double out = side == Side::left ? 1 : -1;
    const dvec3 ankle(out * 0.135, 0.085, side == Side::left ? 0.005 : -0.025);
    place_leg(pose, side, {ankle, 0, 10, 0});
    place_arm(pose, side,
              {.shrug = 3 + 0.9 * wave(phase, side == Side::left ? 0.20 : 0.22, 2),
               .reach = 9 + 0.7 * wave(phase, side == Side::left ? 0.24 : 0.26, 2)});
    const std::string suffix = side == Side::left ? ".L" : ".R";
    const WorldPose world = world_pose(pose);
    const dvec3 hip = world[joint_index("thigh" + suffix)].position;
    const dvec3 knee = world[joint_index("shin" + suffix)].position;
    const dvec3 along = glm::normalize(knee - hip);
    const dvec3 above = glm::normalize(dvec3(0, 1, 0) - along * along.y);
    const dvec3 shoulder = world[joint_index("upper_arm" + suffix)].position;
    const dvec3 above_knee = knee + above * elbow_on_thigh + dvec3(out * 0.010, 0, 0);
    const dvec3 upper = (along_line(above_knee, along, shoulder, elbow_distance) - shoulder) / elbow_distance;
    const dvec3 forearm = glm::normalize(dvec3(-out * 0.41, -0.12 + 0.02 * wave(phase, 0.32), 0.80));
    const dvec3 wrist = shoulder + upper * elbow_distance + forearm * (wrist_distance - elbow_distance);
    place_hand(pose, side,
               {.grip = wrist,
                .rotation = palm_towards(side, dvec3(-out * 0.75, -0.62, -0.10), dvec3(-out * 0.26, -0.62, 0.62)),
                .held = dvec3(0),
                .elbow = upper});
    curl_fingers(pose, side, [&](double late) { return 14 + 3 * wave(phase, 0.3 + 0.08 * late); });
  }
  return pose;
}

}  // namespace

Motion make_lean() { return {"lean", 180, true, lean}; }
Motion make_sit_on_step() { return {"sit on step", 180, true, sit_on_step}; }

}  // namespace throng::mannequin
