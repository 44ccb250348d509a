#pragma once

#include "engine/anim/kernel/limb/foot_placement.h"

namespace throng::anim {

/// Does what foot_placement.h says for one character, without vectors and posing anew what it changed. The kernels are
/// held to it. Returns how far the pelvis was lowered.
float place_feet_by_definition(const FootPlacementJob& job);

}  // namespace throng::anim
