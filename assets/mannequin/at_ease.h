#pragma once

#include "assets/mannequin/pose.h"

namespace throng::mannequin {

/// Both feet where they stand at rest, the heels lifted by so many degrees about the balls. Returns by how many metres
/// the legs are too short.
double stand(Pose& pose, double heel_lift);

/// An arm that hangs, hardly moving; `late` is a share of the cycle.
ArmAngles hanging(double phase, double late);

/// Standing at ease: the weight shifts once per cycle.
Pose stand_at_ease(double phase, int breaths);

}  // namespace throng::mannequin
