#include "engine/anim/survey/bone_lod.h"

#include <algorithm>
#include <cstddef>

#include "engine/anim/survey/bone_importance.h"
#include "engine/anim/survey/lod_survey.h"

namespace throng::anim {

namespace {

std::uint8_t coarsest_level_with(const Skeleton& skeleton, int bone) {
  const auto levels = std::ranges::count_if(skeleton.level_bone_counts, [&](int count) { return bone < count; });
  return static_cast<std::uint8_t>(levels - 1);
}

/// Adds the row of the next bone.
void add_row(const Skeleton& skeleton, float error_metres, BoneLod& lod) {
  const auto bone = static_cast<int>(lod.rows.size());
  lod.rows.push_back({.bone = bone, .error_metres = error_metres, .level = coarsest_level_with(skeleton, bone)});
}

/// The points that change at a level, with their own entries and with the entries that replace them.
struct LevelPoints {
  std::vector<LodPoint> full, reduced;

  LevelPoints(const Skeleton& skeleton, int bone_count, const std::vector<LodPoint>& points) {
    const std::vector<int> kept = kept_entries(skeleton, bone_count);
    for (const LodPoint& point : points) {
      LodPoint without = point;
      for (int& entry : without.entries) entry = kept[static_cast<std::size_t>(entry)];
      if (without.entries == point.entries) continue;
      full.push_back(point);
      reduced.push_back(without);
    }
  }

  float farthest(std::span<const glm::dmat4> palette) const {
    double distance = 0.0;
    for (std::size_t i = 0; i < full.size(); ++i) {
      distance = std::max(distance, glm::distance(skinned(full[i], palette), skinned(reduced[i], palette)));
    }
    return static_cast<float>(distance);
  }
};

void measure_levels(const Model& model, BoneLod& lod) {
  const std::vector<LodPoint> points = pick_lod_points(model);
  std::vector<LevelPoints> levels;
  for (const int count : model.skeleton.level_bone_counts) levels.emplace_back(model.skeleton, count, points);
  std::vector<std::vector<float>> errors(levels.size());
  visit_surveyed_poses(model, [&](std::span<const glm::dmat4> palette) {
    for (std::size_t level = 1; level < levels.size(); ++level)
      errors[level].push_back(levels[level].farthest(palette));
  });
  for (std::size_t level = 1; level < lod.level_error_metres.size(); ++level) {
    const float error = level < levels.size() ? percentile_99(std::move(errors[level])) : 0.0F;
    lod.level_error_metres[level] = std::max(error, lod.level_error_metres[level - 1]);
  }
}

/// A model without keys has no poses to measure its levels in: a level errs at least as its worst dropped limb does.
void take_worst_limbs(const Skeleton& skeleton, BoneLod& lod) {
  for (std::size_t level = 1; level < skeleton.level_bone_counts.size(); ++level) {
    float& error = lod.level_error_metres[level];
    for (auto bone = static_cast<std::size_t>(skeleton.level_bone_counts[level]); bone < lod.rows.size(); ++bone) {
      error = std::max(error, lod.rows[bone].error_metres);
    }
  }
  for (std::size_t level = 1; level < lod.level_error_metres.size(); ++level) {
    lod.level_error_metres[level] = std::max(lod.level_error_metres[level], lod.level_error_metres[level - 1]);
  }
}

}  // namespace

BoneLod measure_bone_lod(const Model& model) {
  BoneLod lod;
  for (const double error : bone_errors(model)) add_row(model.skeleton, static_cast<float>(error), lod);
  measure_levels(model, lod);
  return lod;
}

BoneLod reorder_bone_lod(const BoneLod& lod, const Model& model, std::span<const int> bones) {
  BoneLod reordered;
  for (const int bone : bones) {
    add_row(model.skeleton, lod.rows[static_cast<std::size_t>(bone)].error_metres, reordered);
  }
  measure_levels(model, reordered);
  if (model.clips.empty()) take_worst_limbs(model.skeleton, reordered);
  return reordered;
}

std::vector<int> kept_entries(const Skeleton& skeleton, int bone_count) {
  const std::vector<int> first = first_entries(skeleton);
  std::vector<int> kept;
  for (int entry = 0; entry < skeleton.palette_count(); ++entry) {
    const int own = skeleton.palette[static_cast<std::size_t>(entry)].bone;
    int bone = nearest_kept_bone(skeleton, own, bone_count);
    while (bone >= 0 && first[static_cast<std::size_t>(bone)] == no_entry) bone = skeleton.parent(bone);
    kept.push_back(own < bone_count ? entry : bone < 0 ? 0 : first[static_cast<std::size_t>(bone)]);
  }
  return kept;
}

std::vector<std::vector<std::uint16_t>> entries_at_levels(const Skeleton& skeleton) {
  std::vector<std::vector<std::uint16_t>> levels;
  for (const int bones : skeleton.level_bone_counts) {
    std::vector<std::uint16_t>& entries = levels.emplace_back();
    for (const int entry : kept_entries(skeleton, bones)) entries.push_back(static_cast<std::uint16_t>(entry));
  }
  return levels;
}

}  // namespace throng::anim
