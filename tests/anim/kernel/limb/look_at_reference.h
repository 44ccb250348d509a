#pragma once

#include "engine/anim/kernel/limb/look_at.h"

namespace throng::anim {

/// look_at.h for one character in model space throughout, without vectors: what the kernels are held to. Returns what
/// remains.
float look_at_by_definition(const LookAtJob& job);

}  // namespace throng::anim
