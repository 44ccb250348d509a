#pragma once

#include "engine/anim/kernel/limb/look_at.h"

namespace throng::anim {

/// Does what look_at.h says for one character in model space throughout, without vectors. The kernels are held to it.
/// Returns what remains.
float look_at_by_definition(const LookAtJob& job);

}  // namespace throng::anim
