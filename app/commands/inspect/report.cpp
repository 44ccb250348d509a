#include "app/commands/inspect/report.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/character/roles.h"
#include "app/commands/inspect/text_table.h"
#include "engine/anim/rig/rig_map.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

constexpr std::size_t indent = 2;

/// Names may be empty.
std::string name_text(const std::string& name) { return name.empty() ? "(no name)" : name; }

std::size_t count_keys(const anim::Clip& clip) {
  std::size_t keys = 0;
  for (const anim::BoneTracks& tracks : clip.tracks) {
    keys += tracks.translation.times.size() + tracks.rotation.times.size() + tracks.scale.times.size();
  }
  return keys;
}

std::string rate_text(const anim::BakedClip& clip) {
  return clip.sampled() == nullptr ? "its keys" : fixed(clip.sampled_rate, 0) + " Hz";
}

/// Rows lie only where the error bound needs them, so there are fewer than by the rate.
std::string rows_text(const anim::BakedClip& clip) {
  const anim::SampledStream* const stream = clip.sampled();
  if (stream == nullptr) return "none";
  return std::to_string(stream->row_count) + " of " + std::to_string(stream->step_count + 1);
}

std::string error_text(const anim::BakedClip& clip) {
  return clip.sampled() == nullptr ? "exact" : fixed(clip.sampled_error * 1000.0, 2) + " mm";
}

/// Says how far a loop of the clip leads.
std::string root_text(const anim::BakedClip& clip) {
  constexpr double least = 1e-3;  // metres and radians
  if (clip.root_motion.keys.empty()) return "none";
  const double metres = std::hypot(clip.loop_displacement.x, clip.loop_displacement.z);
  const double climb = clip.loop_displacement.y;
  const double turn = std::abs(clip.root_motion.keys.back().yaw);
  if (metres < least && turn < least && std::abs(climb) < least) return "returns";
  std::string text;
  if (metres >= least) {
    text = fixed(metres, 2) + " m, " + fixed(metres / to_seconds(clip.duration), 2) + " m/s";
  }
  if (std::abs(climb) >= least) text += (text.empty() ? "" : ", ") + fixed(climb, 2) + " m up";
  if (turn >= least) text += (text.empty() ? "" : ", ") + fixed(glm::degrees(turn), 0) + " deg";
  return text;
}

std::string body_size_text(const anim::CharacterBounds& bounds) {
  return "body radius " + fixed(bounds.body_radius, 2) + " m, no pose leaves " + fixed(bounds.reach, 2) +
         " m around its middle";
}

std::string placement_text(const anim::GuessedPlacement& placed) {
  std::string text = placed.reasons;
  if (placed.extent) {
    const glm::dvec3 size = placed.placement.scale * placed.extent->size;
    text += "; " + fixed(size.x, 2) + " m wide, " + fixed(size.z, 2) + " m deep";
  }
  return text + "; --scale, --up and --ground overrule it";
}

std::string skeleton_text(const anim::Skeleton& skeleton) {
  std::string text = counted(skeleton.bones.size(), "bone") + ", " + (skeleton.rigid ? "rigid" : "general") +
                     " path, " + std::to_string(skeleton.palette_count()) + " palette entries; bone levels";
  for (const int count : skeleton.level_bone_counts) text += " " + std::to_string(count);
  return text;
}

/// Lists the parts of the body with their bones.
std::string rig_text(const anim::Skeleton& skeleton, const anim::RigMap& rig) {
  std::string text;
  for (std::size_t role = 0; role < anim::body_role_count; ++role) {
    if (rig.bones[role] < 0) continue;
    const std::string& bone = skeleton.bones[static_cast<std::size_t>(rig.bones[role])].name;
    text += (text.empty() ? "rig: " : ", ") + std::string(anim::body_role_names[role]) + " " + name_text(bone);
  }
  return text.empty() ? "rig: no part of a body is known" : text;
}

TextTable skin_table(const anim::Model& model) {
  TextTable table({"skin", "name", "joints"});
  for (const anim::Skin& skin : model.skins) {
    table.add({std::to_string(skin.skin), name_text(skin.name), std::to_string(skin.bones.size())});
  }
  return table;
}

TextTable clip_table(const anim::Model& model, const anim::Character& character) {
  TextTable table(
      {"clip", "name", "length", "bones", "keys", "played from", "rows", "bytes", "off by", "root motion", "loops"});
  for (std::size_t i = 0; i < model.clips.size(); ++i) {
    const anim::Clip& clip = model.clips[i];
    const anim::BakedClip& baked = character.clips[i];
    table.add({std::to_string(clip.animation), name_text(clip.name), fixed(clip.length(), 2) + " s",
               std::to_string(clip.tracks.size()), std::to_string(count_keys(clip)), rate_text(baked), rows_text(baked),
               std::to_string(bytes_played(baked)), error_text(baked), root_text(baked), baked.loops ? "yes" : "no"});
  }
  return table;
}

TextTable mesh_table(const anim::Model& model) {
  TextTable table({"mesh", "vertices", "triangles", "material"});
  for (const anim::SkinnedMesh& mesh : model.meshes) {
    table.add({name_text(mesh.name), std::to_string(mesh.positions.size()), std::to_string(mesh.indices.size() / 3),
               std::to_string(mesh.material)});
  }
  return table;
}

/// Names the clips that animate a morph.
std::string clips_of_morph(const anim::Model& model, int morph) {
  std::vector<std::string> names;
  for (const anim::Clip& clip : model.clips) {
    const auto has = [morph](const anim::MorphTrack& track) { return std::ranges::count(track.morphs, morph) > 0; };
    if (std::ranges::any_of(clip.morph_tracks, has)) names.push_back(name_text(clip.name));
  }
  return joined(names);
}

TextTable morph_table(const anim::Model& model) {
  TextTable table({"morph", "moves vertices", "at rest", "in clips"});
  std::vector<std::size_t> vertices(model.morphs.size(), 0);
  for (const anim::SkinnedMesh& mesh : model.meshes) {
    for (const anim::MorphDelta& delta : mesh.morph_deltas) ++vertices[delta.morph];
  }
  for (std::size_t i = 0; i < model.morphs.size(); ++i) {
    const anim::Morph& morph = model.morphs[i];
    table.add({morph.name, std::to_string(vertices[i]), fixed(morph.rest_weight, 2),
               clips_of_morph(model, static_cast<int>(i))});
  }
  return table;
}

std::string image_text(const anim::Model& model, int image) {
  if (image < 0) return "none";
  const anim::Image& picture = model.images[static_cast<std::size_t>(image)];
  return std::to_string(picture.width) + "x" + std::to_string(picture.height);
}

std::string color_text(const glm::vec4& color) {
  std::string text;
  for (int i = 0; i < 4; ++i) text += (i > 0 ? " " : "") + fixed(static_cast<double>(color[i]), 2);
  return text;
}

std::string alpha_text(const anim::Material& material) {
  if (material.blended) return "blended";
  return material.alpha_cutoff > 0.0F ? "cut at " + fixed(static_cast<double>(material.alpha_cutoff), 2) : "opaque";
}

std::string light_text(const anim::Material& material) {
  if (material.unlit) return "unlit";
  return material.emission == glm::vec3(0.0F) ? "lit" : "lit, shines";
}

TextTable material_table(const anim::Model& model) {
  TextTable table({"material", "name", "base colour", "picture", "sides", "alpha", "light"});
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    const anim::Material& material = model.materials[i];
    table.add({std::to_string(i), name_text(material.name), color_text(material.base_color),
               image_text(model, material.base_color_texture.image), material.double_sided ? "both" : "front",
               alpha_text(material), light_text(material)});
  }
  return table;
}

std::string baked_lods_text(const anim::Model& model) {
  if (model.mesh_lods.empty()) return {};
  std::string text = "  " + counted(model.mesh_lods.size(), "baked mesh LOD") + ":";
  for (const anim::BakedMeshLod& lod : model.mesh_lods) {
    std::size_t triangles = 0;
    for (const anim::SkinnedMesh& mesh : lod.meshes) triangles += mesh.indices.size() / 3;
    text += " " + std::to_string(triangles);
  }
  return text + " triangles\n";
}

/// Lists the guesses from names, which a person may overrule, and the notes of baking on clips.
std::vector<std::string> guesses(const anim::Model& model, const anim::Character& character) {
  std::vector<std::string> lines;
  std::vector<std::string> names;
  for (const anim::Clip& clip : model.clips) names.push_back(clip.name);
  const CharacterRoles roles = roles_by_name(names);
  std::string played;
  for (std::size_t role = 0; role < role_count; ++role) {
    const int clip = roles.clips[role];
    if (clip == no_clip) continue;
    played +=
        (played.empty() ? "" : ", ") + std::string(role_names[role]) + " " + names[static_cast<std::size_t>(clip)];
  }
  if (!played.empty()) lines.push_back("guessed: roles by the names of clips: " + played);
  for (const anim::BakedClip& clip : character.clips) {
    if (!clip.note.empty()) lines.push_back("noted: clip " + name_text(clip.name) + ": " + clip.note);
  }
  return lines;
}

std::string model_text(const InspectedModel& inspected) {
  const anim::Model& model = inspected.model;
  const anim::Character character = anim::bake_character(model);
  const anim::RigMap rig = anim::find_rig(model.skeleton);
  std::string text = "\nskeleton " + name_text(model.skeleton.name) + "\n";
  for (const std::string& line : {placement_text(inspected.placed), body_size_text(character.bounds),
                                  skeleton_text(model.skeleton), rig_text(model.skeleton, rig)}) {
    text += "  " + line + "\n";
  }
  for (const std::string& doubt : rig.limbs.doubts) text += "  noted: " + doubt + "\n";
  for (const TextTable& table : {skin_table(model), clip_table(model, character), mesh_table(model), morph_table(model),
                                 material_table(model)}) {
    if (!table.is_empty()) text += table.text(indent);
  }
  text += baked_lods_text(model);
  for (const std::string& guess : guesses(model, character)) text += "  " + guess + "\n";
  return text;
}

}  // namespace

std::uint32_t bytes_played(const anim::BakedClip& clip) {
  return clip.sampled() != nullptr ? clip.sampled()->total_size : clip.keyframe()->total_size;
}

std::string inspection_text(const anim::ImportedFile& file, std::span<const InspectedModel> models) {
  std::string text = file.file + ": " + counted(models.size(), "skeleton") + ", " +
                     counted(file.animations.size(), "animation") + ", " +
                     (file.repairs.empty() ? "nothing to repair" : counted(file.repairs.size(), "repair")) + "\n";
  for (const InspectedModel& model : models) text += model_text(model);
  if (!file.notes.empty() || !file.repairs.empty()) text += '\n';
  for (const std::string& note : file.notes) text += "noted: " + note + "\n";
  for (const std::string& repair : file.repairs) {
    text += (repair.find("left out") == std::string::npos ? "repaired: " : "left out: ") + repair + "\n";
  }
  return text;
}

}  // namespace throng::app
