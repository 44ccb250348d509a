#pragma once

#include "engine/anim/base/pose.h"

namespace throng::anim {

/// Add: an additive layer, applied on the right. Rotation base * normalise(identity * (1 - w) + delta * w), delta on
/// identity's hemisphere; position base + w * delta; scale base * (1 + w * (delta - 1)); w = weight * bone weight. A
/// bone of w = 0 keeps the bits of `base`. `out` may be `base` or `delta`.
struct AddJob {
  const float* base = nullptr;          ///< [components][16]
  const float* delta = nullptr;         ///< [components][16], see SubtractJob
  const float* bone_weights = nullptr;  ///< [16], 0 to 1, or null: all 1
  float weight = 0.0F;                  ///< 0 to 1
  int components = rigid_components;
  float* out = nullptr;  ///< [components][16]
};
bool is_valid(const AddJob& job);

}  // namespace throng::anim
