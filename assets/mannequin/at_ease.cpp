#include "assets/mannequin/at_ease.h"

#include <glm/geometric.hpp>

#include "assets/mannequin/clip.h"
#include "assets/mannequin/curve.h"

namespace throng::mannequin {

using glm::dvec3;

double stand(Pose& pose, double heel_lift) {
  double missing = 0;
  for (const Side side : {Side::left, Side::right}) {
    const dvec3 ankle = skeleton()[joint_index("foot.L")].position;
    const dvec3 ball = skeleton()[joint_index("toe.L")].position - ankle;
    constexpr double toe_out = 9;
    const double outward = side == Side::left ? toe_out : -toe_out;
    const glm::dquat flat = turned(0, outward, 0);
    const dvec3 across(side == Side::left ? 1 : -1, 1, 1);
    const dvec3 pivot = flat * (ball * across);
    const dvec3 rolled = turned(heel_lift, outward, 0) * (ball * across);
    missing += place_leg(pose, side, {ankle * across + pivot - rolled, -heel_lift, toe_out, heel_lift});
  }
  return missing;
}

ArmAngles hanging(double phase, double late) {
  return {.flexion = 1 + 1.6 * wave(phase, 0.30 + late),
          .abduction = 8 + 0.9 * wave(phase, 0.22 + late, 2),
          .inward_twist = 4 + 2 * wave(phase, 0.40 + late),
          .elbow = 17 + 2.2 * wave(phase, 0.36 + late),
          .pronation = 14 + 2 * wave(phase, 0.45 + late),
          .wrist_flexion = 3 + 1.6 * wave(phase, 0.50 + late),
          .shrug = 0.9 * wave(phase, 0.20, 2),
          .reach = 1.0 + 0.7 * wave(phase, 0.24, 2)};
}

Pose stand_at_ease(double phase, int breaths) {
  Pose pose;
  const double shift = wave(phase, 0.25);
  const double breath = wave(phase, 0.20, breaths);
  pose.hips = {0.020 * shift, -0.006 - 0.002 * wave(phase, 0.25, 2), 0.004 * wave(phase, 0.10)};
  pose["hips"] = turned(-1.0 + 0.4 * wave(phase, 0.60), 1.6 * wave(phase, 0.30), 1.8 * shift);
  pose["spine"] = turned(0.6 - 0.3 * breath, -0.8 * wave(phase, 0.33), -1.1 * wave(phase, 0.27));
  pose["chest"] = turned(1.0 - 0.9 * breath, -0.6 * wave(phase, 0.36), -0.9 * wave(phase, 0.29));
  pose["upper_chest"] =
      turned(1.2 - 0.8 * wave(phase, 0.23, breaths), -0.5 * wave(phase, 0.40), -0.4 * wave(phase, 0.31));
  steady_head(pose, turned(1.5 + 0.9 * wave(phase, 0.70), 4.0 * wave(phase, 0.15), 1.2 * wave(phase, 0.45)));
  // The eyes arrive before the head does.
  pose["eye.L"] = pose["eye.R"] = turned(1.5 * wave(phase, 0.55), 7 * wave(phase, 0.06) + 3 * wave(phase, 0.40, 2), 0);
  for (const Side side : {Side::left, Side::right}) {
    place_arm(pose, side, hanging(side == Side::left ? phase : phase + 0.5, side == Side::left ? 0.0 : 0.06));
    curl_fingers(pose, side,
                 [&](double late) { return 7 + 2.5 * wave(phase, (side == Side::left ? 0.3 : 0.7) + 0.08 * late); });
  }
  stand(pose, 0);
  return pose;
}

Motion make_idle() {
  return {"idle", 180, true, [](double phase) { return stand_at_ease(phase, 2); }};
}

}  // namespace throng::mannequin
