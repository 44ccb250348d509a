#pragma once

#include "engine/anim/base/pose.h"

namespace throng::anim {

/// Mix: N sources at once, out = normalise(sum of w * q) in their order, each q on the hemisphere of the sum before it;
/// positions and scales linear. w = weight * bone weight, under bone weights divided by their sum bone by bone. A
/// source of w = 0 changes no bit. Where one source has all the weight, its bits are copied; where none has any, the
/// bits of the first source whose `weight` is not 0 (else of the first). `out` may be any of the sources.
inline constexpr int most_mixed_sources = 8;
inline constexpr float least_mixed_weight = 1e-30F;  ///< a bone with a smaller sum of weights has no weight
inline constexpr float most_mixed_excess = 1e-4F;    ///< largest distance of the sum of all weights from 1
struct MixJob {
  const float* const* sources = nullptr;       ///< [count], each [components][16]
  const float* weights = nullptr;              ///< [count], 0 or more, their sum is 1
  const float* const* bone_weights = nullptr;  ///< [count], each [16] from 0 to 1 or null (all 1); or null: all null
  int count = 0;                               ///< 1 to most_mixed_sources
  int components = rigid_components;
  float* out = nullptr;  ///< [components][16]
};
bool is_valid(const MixJob& job);

}  // namespace throng::anim
