#include "app/commands/inspect/command.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "app/character/clip_files.h"
#include "app/character/model_file.h"
#include "app/commands/inspect/report.h"
#include "app/commands/inspect/tracks_report.h"
#include "app/files/exit_status.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/rig/rig_map.h"
#include "engine/anim/survey/placement_guess.h"
#include "engine/base/files/output_file.h"
#include "engine/base/json/json.h"
#include "engine/tracks/read.h"

namespace throng::app {
namespace {

std::size_t count_triangles(const std::vector<anim::SkinnedMesh>& meshes) {
  std::size_t count = 0;
  for (const anim::SkinnedMesh& mesh : meshes) count += mesh.indices.size() / 3;
  return count;
}

const char* path_name(const anim::Skeleton& skeleton) { return skeleton.rigid ? "rigid" : "general"; }

Json rig_json(const anim::Skeleton& skeleton) {
  const anim::RigMap rig = anim::find_rig(skeleton);
  Json parts = Json::object();
  for (std::size_t role = 0; role < anim::body_role_count; ++role) {
    if (rig.bones[role] < 0) continue;
    parts[anim::body_role_names[role]] = skeleton.bones[static_cast<std::size_t>(rig.bones[role])].name;
  }
  return parts;
}

Json mesh_lods_json(const anim::Model& model) {
  Json lods = Json::array();
  for (const anim::BakedMeshLod& lod : model.mesh_lods) {
    lods.push_back({{"error_m", lod.error}, {"triangles", count_triangles(lod.meshes)}});
  }
  return lods;
}

Json skins_json(const anim::Model& model) {
  Json skins = Json::array();
  for (const anim::Skin& skin : model.skins) {
    skins.push_back({{"joints", skin.bones.size()}, {"name", skin.name}, {"skin", skin.skin}});
  }
  return skins;
}

Json sampled_json(const anim::BakedClip& clip) {
  if (clip.sampled() == nullptr) return nullptr;
  return {{"bytes", clip.sampled()->total_size},
          {"rate_hz", clip.sampled_rate},
          {"rows", clip.sampled()->row_count},
          {"surface_error_limit_mm", clip.error_bound * 1000.0},
          {"surface_error_mm", clip.sampled_error * 1000.0}};
}

Json clips_json(const anim::Model& model) {
  const anim::Character baked = anim::bake_character(model);
  Json clips = Json::array();
  for (std::size_t i = 0; i < model.clips.size(); ++i) {
    const anim::Clip& clip = model.clips[i];
    clips.push_back({{"animation", clip.animation},
                     {"bones_animated", clip.tracks.size()},
                     {"duration_s", clip.duration},
                     {"keyframe_bytes", baked.clips[i].keyframe()->total_size},
                     {"name", clip.name},
                     {"note", baked.clips[i].note},
                     {"sampled_stream", sampled_json(baked.clips[i])},
                     {"start_s", clip.start}});
  }
  return clips;
}

Json meshes_json(const anim::Model& model) {
  Json meshes = Json::array();
  for (const anim::SkinnedMesh& mesh : model.meshes) {
    meshes.push_back({{"has_colors", !mesh.colors.empty()},
                      {"has_regions", !mesh.regions.empty()},
                      {"has_texture_coords", !mesh.texture_coords.empty()},
                      {"material", mesh.material},
                      {"name", mesh.name},
                      {"triangles", mesh.indices.size() / 3},
                      {"vertices", mesh.positions.size()}});
  }
  return meshes;
}

Json morphs_json(const anim::Model& model) {
  Json morphs = Json::array();
  for (std::size_t i = 0; i < model.morphs.size(); ++i) {
    Json animations = Json::array();
    for (const anim::Clip& clip : model.clips) {
      const auto has = [i](const anim::MorphTrack& track) {
        return std::ranges::count(track.morphs, static_cast<int>(i)) > 0;
      };
      if (std::ranges::any_of(clip.morph_tracks, has)) animations.push_back(clip.animation);
    }
    morphs.push_back({{"animations", std::move(animations)},
                      {"name", model.morphs[i].name},
                      {"node", model.morphs[i].node},
                      {"rest_weight", model.morphs[i].rest_weight},
                      {"target", model.morphs[i].target}});
  }
  return morphs;
}

Json materials_json(const anim::Model& model) {
  Json materials = Json::array();
  for (const anim::Material& material : model.materials) {
    const auto& color = material.base_color;
    const auto& emission = material.emission;
    materials.push_back({{"alpha_cutoff", material.alpha_cutoff},
                         {"base_color", Json::array({color.r, color.g, color.b, color.a})},
                         {"blended", material.blended},
                         {"double_sided", material.double_sided},
                         {"emission", Json::array({emission.r, emission.g, emission.b})},
                         {"emission_image", material.emission_texture.image},
                         {"image", material.base_color_texture.image},
                         {"metallic", material.metallic},
                         {"metallic_roughness_image", material.metallic_roughness_texture.image},
                         {"name", material.name},
                         {"normal_image", material.normal_texture.image},
                         {"normal_scale", material.normal_scale},
                         {"occlusion_image", material.occlusion_texture.image},
                         {"occlusion_strength", material.occlusion_strength},
                         {"roughness", material.roughness},
                         {"unlit", material.unlit}});
  }
  return materials;
}

Json numbers(const glm::dvec3& vector) { return Json::array({vector.x, vector.y, vector.z}); }

/// Says size and place of a model, before and after.
Json size_json(const anim::GuessedPlacement& placed) {
  const anim::ModelExtent extent = placed.extent.value_or(anim::ModelExtent{});
  return {{"file_lowest", extent.lowest},
          {"file_middle", numbers(extent.middle)},
          {"file_size", numbers(extent.size)},
          {"height_m", placed.height},
          {"offset_m", numbers(placed.placement.offset)},
          {"reasons", placed.reasons},
          {"scale", placed.placement.scale}};
}

Json model_json(const InspectedModel& inspected) {
  const anim::Model& model = inspected.model;
  Json bones = Json::array();
  for (const anim::Bone& bone : model.skeleton.bones) bones.push_back(bone.name);
  Json images = Json::array();
  for (const anim::Image& image : model.images) images.push_back({{"height", image.height}, {"width", image.width}});
  return {{"bones", std::move(bones)},           {"clips", clips_json(model)},
          {"images", std::move(images)},         {"level_bone_counts", model.skeleton.level_bone_counts},
          {"materials", materials_json(model)},  {"mesh_lods", mesh_lods_json(model)},
          {"meshes", meshes_json(model)},        {"morphs", morphs_json(model)},
          {"name", model.skeleton.name},         {"palette_entries", model.skeleton.palette_count()},
          {"path", path_name(model.skeleton)},   {"rig", rig_json(model.skeleton)},
          {"size", size_json(inspected.placed)}, {"skins", skins_json(model)}};
}

/// Says what the file holds as one JSON object; README.md beside this file lists the keys.
std::string inspection_json(const anim::ImportedFile& file, const std::vector<InspectedModel>& inspected) {
  Json models = Json::array();
  for (const InspectedModel& model : inspected) models.push_back(model_json(model));
  const Json inspection = {{"animations", file.animations},
                           {"file", file.file},
                           {"models", std::move(models)},
                           {"notes", file.notes},
                           {"repairs", file.repairs}};
  return inspection.dump(2) + "\n";
}

/// Takes the models out of the file and gives them size and place.
std::vector<InspectedModel> placed_models(anim::ImportedFile& file, const anim::PlacementChoice& choice) {
  std::vector<InspectedModel> models;
  for (anim::Model& model : file.models) {
    const anim::GuessedPlacement placed = anim::guess_placement(model, choice, anim::SizeRule::among_people);
    anim::place_model(model, placed.placement);
    models.push_back({std::move(model), placed});
  }
  return models;
}

Status inspect(const InspectOptions& options) {
  if (looks_like_trajectories(options.model)) return inspect_tracks(options);
  if (!options.measures.empty() || options.count_line) {
    return Error{std::string(options.count_line ? "--count-line: " : "--measures: ") + options.model +
                 " is no file of trajectories; name one, or leave the option out"};
  }
  if (options.tracks.reading != TrackReading{.up = options.tracks.reading.up}) {
    return Error{options.model + ": it is no file of trajectories; leave out --fps and what else is for their rows"};
  }
  auto file = read_model_file(options.model, options.reading);
  if (!file) return file.error();
  anim::face_forward(*file);
  Status added = add_clips_to(options.model, options.clips_from, *file, options.reading);
  if (!added) return added;
  const std::vector<InspectedModel> models = placed_models(*file, options.placement);
  return print(options.json ? inspection_json(*file, models) : inspection_text(*file, models));
}

}  // namespace

int run_inspect(const InspectOptions& options) { return end_with(inspect(options)); }

}  // namespace throng::app
