#pragma once

#include "engine/anim/base/pose.h"

namespace throng::anim {

/// Blend: out = normalise(from * (1 - w) + (to on from's hemisphere) * w), w = fraction * bone weight; positions and
/// scales linear. Under bone weights, a bone of w = 0 has the bits of `from` and one of w = 1 the bits of `to`.
/// `out` may be `from` or `to`.
struct BlendJob {
  const float* from = nullptr;          ///< [components][16]
  const float* to = nullptr;            ///< [components][16]
  const float* bone_weights = nullptr;  ///< [16], 0 to 1, or null: all 1
  float fraction = 0.0F;                ///< 0 to 1
  int components = rigid_components;
  float* out = nullptr;  ///< [components][16]
};
bool is_valid(const BlendJob& job);

}  // namespace throng::anim
