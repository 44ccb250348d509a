#pragma once

#include <cstddef>

#include "engine/base/simd_targets.h"

namespace throng::anim {

struct Kernels;

/// Each function sets a room's kernels in the table of one target. `target` is an index into Highway's dispatch tables.
void set_pose_kernels(std::size_t target, Kernels& kernels);
void set_limb_kernels(std::size_t target, Kernels& kernels);
void set_palette_kernels(std::size_t target, Kernels& kernels);

}  // namespace throng::anim
