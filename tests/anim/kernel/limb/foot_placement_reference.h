#pragma once

#include "engine/anim/kernel/limb/foot_placement.h"

namespace throng::anim {

/// foot_placement.h for one character, without vectors and posing anew what it changed: what the kernels are held to.
/// Returns how far the pelvis was lowered.
float place_feet_by_definition(const FootPlacementJob& job);

}  // namespace throng::anim
