#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// One bone of the order of which levels are prefixes.
struct BoneLodRow {
  int bone = 0;               ///< index in the skeleton: its place in the order
  float error_metres = 0.0F;  ///< see bone_errors
  std::uint8_t level = 0;     ///< the coarsest level that still has it
};

/// What per-bone level of detail costs a character in looks, measured on its surface (paper 3.2).
struct BoneLod {
  std::vector<BoneLodRow> rows;  ///< one a bone, in order
  /// How far the surface of a level is from that of level 0: the farthest point of each pose, the 99th percentile over
  /// poses of all clips; metres. Never falls from level to level; a level that the character lacks repeats the
  /// coarsest.
  std::array<float, max_bone_levels> level_error_metres{};
};

/// Measures the levels that the model's skeleton has.
BoneLod measure_bone_lod(const Model& model);

/// For each palette entry the one that takes its place where only the first `bone_count` bones are kept: itself, or the
/// first entry of its bone's nearest kept ancestor that has one.
std::vector<int> kept_entries(const Skeleton& skeleton, int bone_count);

}  // namespace throng::anim
