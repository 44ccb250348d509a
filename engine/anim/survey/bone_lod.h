#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// One bone of an order whose prefixes are levels.
struct BoneLodRow {
  int bone = 0;               ///< index in the skeleton, which is its place in the order
  float error_metres = 0.0F;  ///< see bone_errors
  std::uint8_t level = 0;     ///< the coarsest level that has it
};

/// The errors that dropping bones causes on a character's surface (paper 3.2).
struct BoneLod {
  std::vector<BoneLodRow> rows;  ///< one a bone, in order
  /// The distance of each level's surface from level 0's, in metres: the farthest point of each pose, and the
  /// 99th percentile over poses of all clips. It never falls from level to level. A level that the character lacks
  /// repeats the coarsest.
  std::array<float, max_bone_levels> level_error_metres{};
};

/// Measures the levels that the model's skeleton has.
BoneLod measure_bone_lod(const Model& model);

/// Returns what measure_bone_lod finds on `model`, whose bones were measured in another order; `bones` has the former
/// index of each. A bone's error stays with it, and only levels are measured.
/// Without the keys of its clips, a level errs as its worst dropped limb does.
BoneLod reorder_bone_lod(const BoneLod& lod, const Model& model, std::span<const int> bones);

/// Returns for each palette entry its replacement when only the first `bone_count` bones are kept: itself, or
/// the first entry of its bone's nearest kept ancestor that has one.
std::vector<int> kept_entries(const Skeleton& skeleton, int bone_count);
/// Returns, for each bone level and palette entry, the entry that a mesh reads at that level.
std::vector<std::vector<std::uint16_t>> entries_at_levels(const Skeleton& skeleton);

}  // namespace throng::anim
