#include "app/commands/inspect/command.h"

#include <cstddef>
#include <cstdio>
#include <sstream>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/files/exit_status.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/import/import.h"

namespace throng::app {

namespace {

using nlohmann::json;

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

void write_model(std::ostream& out, const anim::Model& model) {
  const anim::Character baked = anim::bake_character(model);
  const anim::Skeleton& skeleton = model.skeleton;
  out << "skeleton \"" << skeleton.name << "\": " << skeleton.bone_count() << " bones, " << path_name(skeleton)
      << " path, " << skeleton.palette_count() << " palette entries, levels";
  for (const int count : skeleton.level_bone_counts) out << ' ' << count;
  out << '\n';
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

json mesh_lods_json(const anim::Model& model) {
  json lods = json::array();
  for (const anim::BakedMeshLod& lod : model.mesh_lods) {
    lods.push_back({{"triangles", count_triangles(lod.meshes)}, {"error_m", lod.error}});
  }
  return lods;
}

json skins_json(const anim::Model& model) {
  json skins = json::array();
  for (const anim::Skin& skin : model.skins) {
    skins.push_back({{"skin", skin.skin}, {"name", skin.name}, {"joints", skin.bones.size()}});
  }
  return skins;
}

json sampled_json(const anim::BakedClip& clip) {
  if (clip.sampled() == nullptr) return nullptr;
  return {{"rate_hz", clip.sampled_rate},
          {"bytes", clip.sampled()->total_size},
          {"rows", clip.sampled()->row_count},
          {"surface_error_mm", clip.sampled_error * 1000.0},
          {"surface_error_limit_mm", clip.error_bound * 1000.0}};
}

json clips_json(const anim::Model& model) {
  const anim::Character baked = anim::bake_character(model);
  json clips = json::array();
  for (std::size_t i = 0; i < model.clips.size(); ++i) {
    const anim::Clip& clip = model.clips[i];
    clips.push_back({{"animation", clip.animation},
                     {"name", clip.name},
                     {"start_s", clip.start},
                     {"duration_s", clip.duration},
                     {"bones_animated", clip.tracks.size()},
                     {"sampled_stream", sampled_json(baked.clips[i])},
                     {"keyframe_bytes", baked.clips[i].keyframe().total_size},
                     {"note", baked.clips[i].note}});
  }
  return clips;
}

json meshes_json(const anim::Model& model) {
  json meshes = json::array();
  for (const anim::SkinnedMesh& mesh : model.meshes) {
    meshes.push_back({{"name", mesh.name},
                      {"material", mesh.material},
                      {"vertices", mesh.positions.size()},
                      {"triangles", mesh.indices.size() / 3},
                      {"has_texture_coords", !mesh.texture_coords.empty()},
                      {"has_colors", !mesh.colors.empty()},
                      {"has_regions", !mesh.regions.empty()}});
  }
  return meshes;
}

json materials_json(const anim::Model& model) {
  json materials = json::array();
  for (const anim::Material& material : model.materials) {
    const auto& color = material.base_color;
    materials.push_back({{"name", material.name},
                         {"base_color", {color.r, color.g, color.b, color.a}},
                         {"image", material.image},
                         {"double_sided", material.double_sided}});
  }
  return materials;
}

json model_json(const anim::Model& model) {
  json bones = json::array();
  for (const anim::Bone& bone : model.skeleton.bones) bones.push_back(bone.name);
  json images = json::array();
  for (const anim::Image& image : model.images) images.push_back({{"width", image.width}, {"height", image.height}});
  return {{"name", model.skeleton.name},
          {"path", path_name(model.skeleton)},
          {"bones", std::move(bones)},
          {"level_bone_counts", model.skeleton.level_bone_counts},
          {"palette_entries", model.skeleton.palette_count()},
          {"skins", skins_json(model)},
          {"clips", clips_json(model)},
          {"meshes", meshes_json(model)},
          {"mesh_lods", mesh_lods_json(model)},
          {"materials", materials_json(model)},
          {"images", std::move(images)}};
}

}  // namespace

std::string inspection_text(const anim::ImportedFile& file) {
  std::ostringstream out;
  out << file.file << ": " << file.models.size() << " skeletons, " << file.animations.size() << " animations\n";
  for (const anim::Model& model : file.models) write_model(out, model);
  for (const std::string& repair : file.repairs) out << "repaired: " << repair << '\n';
  return out.str();
}

std::string inspection_json(const anim::ImportedFile& file) {
  json models = json::array();
  for (const anim::Model& model : file.models) models.push_back(model_json(model));
  const json inspection = {
      {"file", file.file}, {"animations", file.animations}, {"models", std::move(models)}, {"repairs", file.repairs}};
  return inspection.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

int run_inspect(const InspectOptions& options) {
  const auto file = import::import_file(options.model);
  if (!file) return end_with(exit_job_failed, file.error().message);
  const std::string text = options.json ? inspection_json(*file) : inspection_text(*file);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    return end_with(exit_job_failed, "standard output cannot be written");
  }
  return exit_done;
}

}  // namespace throng::app
