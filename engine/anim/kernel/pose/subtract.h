#pragma once

#include "engine/anim/base/pose.h"

namespace throng::anim {

/// Subtract: the delta that AddJob adds. Rotation reference^-1 * pose, with w >= 0; position pose - reference; scale
/// pose / reference, and 1 where the reference is 0. Added to the reference with a weight of 1 it gives the pose, its
/// rotation up to the sign. `out` may be `pose` or `reference`.
struct SubtractJob {
  const float* pose = nullptr;       ///< [components][16]
  const float* reference = nullptr;  ///< [components][16]
  int components = rigid_components;
  float* out = nullptr;  ///< [components][16]
};
bool is_valid(const SubtractJob& job);

}  // namespace throng::anim
