#include "app/show/lod/lod_export.h"

#include <filesystem>

#include "app/character/bone_lod.h"
#include "app/settings/choices.h"
#include "app/show/lod/lod_thresholds.h"
#include "app/show/lod/tuned_view.h"
#include "engine/base/json/json.h"
#include "engine/crowd/mesh_lods.h"

namespace throng::app {
namespace {

constexpr int lod_export_version = 3;
constexpr float frame_seconds = 1.0F / 60.0F;

/// A distance, and the height on screen of the character there; null at the camera.
Json from(const LodInForce& lod, double metres, double height) {
  const double pixels = height * static_cast<double>(lod.pixels_per_unit);
  return {{"from_distance_metres", metres}, {"below_pixels_tall", metres > 0.0 ? Json(pixels / metres) : Json()}};
}

Json intervals_of(const LodInForce& lod, double height) {
  Json intervals = Json::array();
  const auto add = [&](int interval, double metres) {
    Json row = from(lod, metres, height);
    row["interval_frames"] = interval;
    intervals.push_back(std::move(row));
  };
  if (lod.tuning.lod.rule == LodRule::budget) return intervals;
  add(1, 0.0);
  if (lod.tuning.lod.rule == LodRule::off) return intervals;
  for (const IntervalThreshold& threshold : interval_thresholds(lod.tuning)) {
    add(threshold.interval, static_cast<double>(threshold.metres));
  }
  return intervals;
}

Json choices_of(const LodInForce& lod, const anim::MotionLod& motion, double height) {
  const ErrorView view{.tolerance_pixels = lod.tolerance_pixels, .pixels_per_unit = lod.pixels_per_unit};
  Json choices = Json::array();
  for (const auto& [metres, choice] : choice_thresholds(motion, view)) {
    Json row = from(lod, static_cast<double>(metres), height);
    row["interval_frames"] = choice.interval;
    row["bone_level"] = choice.bone_level;
    row["error_metres"] = motion.error_metres(choice);
    choices.push_back(std::move(row));
  }
  return choices;
}

/// Errors of skipping differ from clip to clip. The first row is of standing still.
Json clips_of(const CharacterSource& source, const LodInForce& lod, double height) {
  Json clips = Json::array();
  if (lod.tuning.lod.rule != LodRule::budget) return clips;
  anim::LodChoices choices;
  choices.build({&lod.character, 1}, lod.tuning.lod, frame_seconds);
  for (int clip = -1; clip < static_cast<int>(source.clip_names.size()); ++clip) {
    const Json name = clip < 0 ? Json() : Json(source.clip_names[static_cast<std::size_t>(clip)]);
    clips.push_back({{"clip", name}, {"choices", choices_of(lod, choices.of(0, clip), height)}});
  }
  return clips;
}

// By the distance rule, and where updates are not skipped, bone levels go by distance alone.
Json levels_of(std::span<const LodLevel> levels, const LodInForce& lod, double height) {
  const bool by_distance = lod.tuning.lod.bone_lod && lod.tuning.lod.rule != LodRule::budget;
  Json rows = Json::array();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const LodLevel& level = levels[i];
    Json row = {{"level", i},
                {"bones", level.bones},
                {"palette_entries", level.palette_entries},
                {"error_metres", level.error_metres},
                {"one_pixel_below_pixels_tall", level.error_metres > 0.0 ? Json(height / level.error_metres) : Json()},
                {"nanoseconds", level.nanoseconds},
                {"from_distance_metres", nullptr},
                {"error_pixels_there", nullptr}};
    const double metres = i == 0 ? 0.0 : static_cast<double>(lod.tuning.lod.level_distances[i - 1]);
    if (by_distance || i == 0) row["from_distance_metres"] = metres;
    if (by_distance && i > 0) {
      row["error_pixels_there"] = level.error_metres * static_cast<double>(lod.pixels_per_unit) / metres;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Json meshes_of(std::span<const MeshLevel> meshes, const Tuning& tuning, double height) {
  const MeshTolerance tolerance = mesh_rules(tuning).tolerance;
  Json rows = Json::array();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const auto error = static_cast<double>(meshes[i].error.surface);
    const float below = fine_below(shares_of(meshes[i].error, height), tolerance);
    const bool by_error = tuning.mesh_lod < 0 && error > 0.0;
    rows.push_back({{"level", i},
                    {"triangles", meshes[i].triangles},
                    {"error_metres", error},
                    {"face_error_metres", meshes[i].error.face},
                    {"one_pixel_below_pixels_tall", error > 0.0 ? Json(height / error) : Json()},
                    {"below_pixels_tall", by_error ? Json(below) : Json()}});
  }
  return rows;
}

Json rule_of(const LodInForce& lod) {
  const Tuning& tuning = lod.tuning;
  const bool by_error = tuning.lod.rule == LodRule::budget;
  const auto where = [](bool is, auto value) { return is ? Json(value) : Json(); };
  return {{"rule", lod_rule_words[static_cast<std::size_t>(tuning.lod.rule)]},
          {"largest_interval_frames", tuning.lod.rule == LodRule::off ? 1 : tuning.lod.largest_interval},
          {"frame_seconds", frame_seconds},
          {"smooth", tuning.lod.smooth && tuning.lod.rule != LodRule::off},
          {"error_limit_pixels", where(by_error && tuning.error_px > 0.0F, tuning.error_px)},
          {"budget_milliseconds", where(by_error && tuning.budget_ms > 0.0F, tuning.budget_ms)},
          {"tolerance_pixels", where(by_error, lod.tolerance_pixels)},
          {"bone_lod", tuning.lod.bone_lod},
          {"mesh_level", where(tuning.mesh_lod >= 0, tuning.mesh_lod)}};
}

Json bones_of(const anim::Character& character) {
  const std::vector<std::string> keys = bone_keys(character.skeleton);
  Json bones = Json::array();
  for (const anim::BoneLodRow& row : character.bone_lod.rows) {
    const anim::Bone& bone = character.skeleton.bones[static_cast<std::size_t>(row.bone)];
    bones.push_back({{"bone", keys[static_cast<std::size_t>(row.bone)]},
                     {"node", bone.node},
                     {"parent", bone.parent < 0 ? Json() : Json(keys[static_cast<std::size_t>(bone.parent)])},
                     {"coarsest_level", row.level},
                     {"error_metres", row.error_metres}});
  }
  return bones;
}

}  // namespace

std::vector<LodLevel> lod_levels(const CharacterSource& source) {
  const anim::Skeleton& skeleton = source.character->skeleton;
  std::vector<LodLevel> levels;
  for (std::size_t i = 0; i < skeleton.level_bone_counts.size(); ++i) {
    levels.push_back({.bones = skeleton.level_bone_counts[i],
                      .palette_entries = anim::palette_count_for_bones(skeleton, skeleton.level_bone_counts[i]),
                      .error_metres = static_cast<double>(source.character->bone_lod.level_error_metres[i]),
                      .nanoseconds = nanoseconds_at_level(skeleton, i)});
  }
  return levels;
}

std::vector<MeshLevel> mesh_levels(std::span<const std::uint32_t> triangles,
                                   std::span<const render::MeshError> errors) {
  std::vector<MeshLevel> levels;
  for (std::size_t i = 0; i < triangles.size(); ++i) levels.push_back({triangles[i], errors[i]});
  return levels;
}

std::string lod_as_json(const CharacterSource& source, std::span<const LodLevel> levels,
                        std::span<const MeshLevel> meshes, const LodInForce& lod) {
  const double height = source.character->bounds.height;
  const Json all = {{"version", lod_export_version},
                    {"character", std::filesystem::path(source.name).filename().string()},
                    {"height_metres", height},
                    {"pixels_of_a_metre_at_one_metre", lod.pixels_per_unit},
                    {"in_force", rule_of(lod)},
                    {"intervals", intervals_of(lod, height)},
                    {"clips", clips_of(source, lod, height)},
                    {"bone_levels", levels_of(levels, lod, height)},
                    {"mesh_levels", meshes_of(meshes, lod.tuning, height)},
                    {"bones", bones_of(*source.character)}};
  return all.dump(2) + "\n";
}

}  // namespace throng::app
