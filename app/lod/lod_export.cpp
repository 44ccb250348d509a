#include "app/character/lod_export.h"

#include <algorithm>

#include "app/character/bone_lod.h"
#include "engine/anim/import/json/json.h"

namespace throng::app {
namespace {

constexpr int lod_export_version = 2;

Json intervals_of(const anim::LodRules& rules, double height, double pixels_per_unit) {
  Json intervals = Json::array();
  for (int interval = 1; interval <= rules.largest_interval; ++interval) {
    const int steps = interval - 2;
    const double from = interval == 1 ? 0.0
                                      : static_cast<double>(rules.full_rate_distance) +
                                            static_cast<double>(rules.interval_growth) * steps;
    Json row = {{"interval_frames", interval}, {"from_distance_metres", from}};
    row["below_pixels_tall"] = from > 0.0 ? Json(height * pixels_per_unit / from) : Json();
    intervals.push_back(std::move(row));
  }
  return intervals;
}

Json levels_of(std::span<const LodLevel> levels, const anim::LodRules& rules, double height, double pixels_per_unit) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const LodLevel& level = levels[i];
    const double from = i == 0 ? 0.0 : static_cast<double>(rules.level_distances[i - 1]);
    rows.push_back(
        {{"level", i},
         {"bones", level.bones},
         {"palette_entries", level.palette_entries},
         {"from_distance_metres", from},
         {"error_metres", level.error_metres},
         {"error_pixels_there", from > 0.0 ? Json(level.error_metres * pixels_per_unit / from) : Json(0.0)},
         {"one_pixel_below_pixels_tall", level.error_metres > 0.0 ? Json(height / level.error_metres) : Json()},
         {"nanoseconds", level.nanoseconds}});
  }
  return rows;
}

Json meshes_of(std::span<const MeshLevel> meshes, double height) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const auto error = static_cast<double>(meshes[i].error_metres);
    rows.push_back({{"level", i},
                    {"triangles", meshes[i].triangles},
                    {"error_metres", error},
                    {"one_pixel_below_pixels_tall", error > 0.0 ? Json(height / error) : Json()}});
  }
  return rows;
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

std::vector<MeshLevel> mesh_levels(std::span<const std::uint32_t> triangles, std::span<const float> errors) {
  std::vector<MeshLevel> levels;
  for (std::size_t i = 0; i < triangles.size(); ++i) levels.push_back({triangles[i], errors[i]});
  return levels;
}

std::string lod_as_json(const CharacterSource& source, std::span<const LodLevel> levels,
                        std::span<const MeshLevel> meshes, const anim::LodRules& rules, double pixels_per_unit) {
  const Json all = {{"version", lod_export_version},
                    {"character", source.name},
                    {"height_metres", source.character->bounds.height},
                    {"pixels_of_a_metre_at_one_metre", pixels_per_unit},
                    {"intervals", intervals_of(rules, source.character->bounds.height, pixels_per_unit)},
                    {"bone_levels", levels_of(levels, rules, source.character->bounds.height, pixels_per_unit)},
                    {"mesh_levels", meshes_of(meshes, source.character->bounds.height)},
                    {"bones", bones_of(*source.character)}};
  return all.dump(2) + "\n";
}

}  // namespace throng::app
