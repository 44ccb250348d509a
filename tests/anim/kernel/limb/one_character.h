#pragma once

#include "engine/anim/kernel/limb/foot_placement.h"
#include "engine/anim/kernel/limb/look_at.h"
#include "engine/anim/kernel/limb/two_bone_ik.h"

namespace throng::anim {

/// Each function runs one job alone on the best kernels, which take up to a strip of jobs and give the same bits.

/// Returns how far the pelvis was lowered, in metres.
float place_feet(const FootPlacementJob& job);
/// Returns how far the end is from the target now, in metres.
float solve_two_bone_ik(const TwoBoneIkJob& job);
/// Returns what remains to the target, in radians.
float look_at(const LookAtJob& job);

}  // namespace throng::anim
