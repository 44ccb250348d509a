#include "app/commands/inspect/command.h"

#include <cstddef>
#include <cstdio>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "app/character/clip_files.h"
#include "app/character/source.h"
#include "app/files/exit_status.h"
#include "app/files/joined.h"
#include "app/files/json.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/import/import.h"
#include "engine/anim/rig/rig_map.h"

namespace throng::app {
namespace {

std::size_t count_vertices(const anim::Model& model) {
  std::size_t count = 0;
  for (const anim::SkinnedMesh& mesh : model.meshes) count += mesh.positions.size();
  return count;
}

std::size_t count_triangles(const std::vector<anim::SkinnedMesh>& meshes) {
  std::size_t count = 0;
  for (const anim::SkinnedMesh& mesh : meshes) count += mesh.indices.size() / 3;
  return count;
}

const char* path_name(const anim::Skeleton& skeleton) { return skeleton.rigid ? "rigid" : "general"; }

/// The streams that a clip is baked into, as the crowd would play them.
void write_streams(std::ostream& out, const anim::BakedClip& clip) {
  const anim::SampledStream* const sampled = clip.sampled();
  if (sampled == nullptr) {
    out << "    plays from its keys, " << clip.keyframe().total_size << " bytes: " << clip.note << '\n';
    return;
  }
  out << "    sampled at " << clip.sampled_rate << " Hz: " << sampled->total_size << " bytes, at most "
      << clip.sampled_error * 1000.0 << " mm off on the surface; its keys: " << clip.keyframe().total_size
      << " bytes\n";
}

/// Lists the parts of the body with their bones, and says why others are missing.
std::string rig_text(const anim::Skeleton& skeleton) {
  const anim::RigMap rig = anim::find_rig(skeleton);
  std::vector<std::string> parts;
  for (std::size_t role = 0; role < anim::body_role_count; ++role) {
    if (rig.bones[role] < 0) continue;
    parts.push_back(std::string(anim::body_role_names[role]) + " " +
                    skeleton.bones[static_cast<std::size_t>(rig.bones[role])].name);
  }
  std::string text = parts.empty() ? "no part of a body is known" : joined(parts);
  for (const std::string& doubt : rig.limbs.doubts) text += "\n    " + doubt;
  return text;
}

Json rig_json(const anim::Skeleton& skeleton) {
  const anim::RigMap rig = anim::find_rig(skeleton);
  Json parts = Json::object();
  for (std::size_t role = 0; role < anim::body_role_count; ++role) {
    if (rig.bones[role] < 0) continue;
    parts[anim::body_role_names[role]] = skeleton.bones[static_cast<std::size_t>(rig.bones[role])].name;
  }
  return parts;
}

void write_model(std::ostream& out, const anim::Model& model) {
  const anim::Character baked = anim::bake_character(model);
  const anim::Skeleton& skeleton = model.skeleton;
  out << "skeleton \"" << skeleton.name << "\": " << skeleton.bone_count() << " bones, " << path_name(skeleton)
      << " path, " << skeleton.palette_count() << " palette entries, levels";
  for (const int count : skeleton.level_bone_counts) out << ' ' << count;
  out << '\n';
  out << "  rig: " << rig_text(skeleton) << '\n';
  for (const anim::Skin& skin : model.skins) {
    out << "  skin " << skin.skin << " \"" << skin.name << "\": " << skin.bones.size() << " joints\n";
  }
  for (std::size_t i = 0; i < model.clips.size(); ++i) {
    const anim::Clip& clip = model.clips[i];
    out << "  clip " << clip.animation << " \"" << clip.name << "\": " << clip.duration << " s, " << clip.tracks.size()
        << " bones animated\n";
    write_streams(out, baked.clips[i]);
  }
  out << "  " << model.meshes.size() << " meshes: " << count_vertices(model) << " vertices, "
      << count_triangles(model.meshes) << " triangles, " << model.materials.size() << " materials, "
      << model.images.size() << " images\n";
  if (model.mesh_lods.empty()) return;
  out << "  " << model.mesh_lods.size() << " baked mesh LODs:";
  for (const anim::BakedMeshLod& lod : model.mesh_lods) out << ' ' << count_triangles(lod.meshes);
  out << " triangles\n";
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
                     {"keyframe_bytes", baked.clips[i].keyframe().total_size},
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

Json materials_json(const anim::Model& model) {
  Json materials = Json::array();
  for (const anim::Material& material : model.materials) {
    const auto& color = material.base_color;
    materials.push_back({{"base_color", Json::array({color.r, color.g, color.b, color.a})},
                         {"double_sided", material.double_sided},
                         {"image", material.image},
                         {"name", material.name}});
  }
  return materials;
}

Json model_json(const anim::Model& model) {
  Json bones = Json::array();
  for (const anim::Bone& bone : model.skeleton.bones) bones.push_back(bone.name);
  Json images = Json::array();
  for (const anim::Image& image : model.images) images.push_back({{"height", image.height}, {"width", image.width}});
  return {{"bones", std::move(bones)},
          {"clips", clips_json(model)},
          {"images", std::move(images)},
          {"level_bone_counts", model.skeleton.level_bone_counts},
          {"materials", materials_json(model)},
          {"mesh_lods", mesh_lods_json(model)},
          {"meshes", meshes_json(model)},
          {"name", model.skeleton.name},
          {"palette_entries", model.skeleton.palette_count()},
          {"path", path_name(model.skeleton)},
          {"rig", rig_json(model.skeleton)},
          {"skins", skins_json(model)}};
}

/// Says for a person what the file holds.
std::string inspection_text(const anim::ImportedFile& file) {
  std::ostringstream out;
  out << file.file << ": " << file.models.size() << " skeletons, " << file.animations.size() << " animations\n";
  for (const anim::Model& model : file.models) write_model(out, model);
  for (const std::string& repair : file.repairs) out << "repaired: " << repair << '\n';
  return out.str();
}

/// Says the same as one JSON object; README.md beside this file lists the keys.
std::string inspection_json(const anim::ImportedFile& file) {
  Json models = Json::array();
  for (const anim::Model& model : file.models) models.push_back(model_json(model));
  const Json inspection = {
      {"animations", file.animations}, {"file", file.file}, {"models", std::move(models)}, {"repairs", file.repairs}};
  return inspection.dump(2) + "\n";
}

}  // namespace

int run_inspect(const InspectOptions& options) {
  auto file = import::import_file(options.model);
  if (!file) return end_with(exit_job_failed, file.error().message);
  const anim::Status added = add_clips_to(options.model, options.clips_from, *file);
  if (!added) return end_with(exit_job_failed, added.error().message);
  const std::string text = options.json ? inspection_json(*file) : inspection_text(*file);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    return end_with(exit_job_failed, "standard output cannot be written");
  }
  return exit_done;
}

}  // namespace throng::app
