#include "throng/character.h"

#include <algorithm>
#include <utility>

#include "engine/anim/api/character_data.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/bake/clip_roles.h"
#include "engine/anim/bake/clip_set.h"
#include "engine/anim/base/misuse.h"
#include "engine/anim/kernel/palette/hierarchy.h"
#include "engine/anim/survey/bone_lod.h"

namespace throng {
namespace {

const anim::Character& no_character() {
  static const anim::Character empty;
  return empty;
}

const anim::Character& baked(const detail::CharacterData* data) {
  return data == nullptr ? no_character() : *data->baked;
}

bool has_bone(const anim::Character& character, int bone) {
  return bone >= 0 && bone < character.skeleton.bone_count();
}

/// Returns vectors of GLM as the structs of floats that they are.
template <typename To, typename From>
std::span<const To> as_floats(const std::vector<From>& from) {
  static_assert(sizeof(To) == sizeof(From) && alignof(To) <= alignof(From));
  return {reinterpret_cast<const To*>(from.data()), from.size()};
}

std::span<const std::array<float, 2>> coords_of(const anim::SkinnedMesh& mesh, int set) {
  const auto place = static_cast<std::size_t>(set);
  if (place >= mesh.texture_coords.size()) return {};
  return as_floats<std::array<float, 2>>(mesh.texture_coords[place]);
}

TextureView texture_of(const detail::CharacterBody& data, const anim::SkinnedMesh& mesh, const anim::Texture& texture) {
  const auto place = static_cast<std::size_t>(texture.image);
  if (place >= data.model.images.size()) return {};
  const anim::Image& image = data.model.images[place];
  return {
      .texels = image.rgba, .width = image.width, .height = image.height, .coords = coords_of(mesh, texture.coords)};
}

AlphaMode alpha_of(const anim::Material& material) {
  if (material.blended) return AlphaMode::blend;
  return material.alpha_cutoff > 0.0F ? AlphaMode::mask : AlphaMode::opaque;
}

void show_material(const detail::CharacterBody& data, const anim::SkinnedMesh& mesh, MeshView& view) {
  const auto place = static_cast<std::size_t>(mesh.material);
  if (place >= data.model.materials.size()) return;
  const anim::Material& material = data.model.materials[place];
  for (int i = 0; i < 4; ++i) view.base_color[static_cast<std::size_t>(i)] = material.base_color[i];
  for (int i = 0; i < 3; ++i) view.emission[static_cast<std::size_t>(i)] = material.emission[i];
  const TextureView base_color = texture_of(data, mesh, material.base_color_texture);
  view.base_color_texels = base_color.texels;
  view.texture_width = base_color.width;
  view.texture_height = base_color.height;
  if (!base_color.texels.empty()) view.texture_coords = base_color.coords;
  view.alpha = alpha_of(material);
  view.alpha_cutoff = material.alpha_cutoff;
  view.double_sided = material.double_sided;
  view.unlit = material.unlit;
  view.metallic = material.metallic;
  view.roughness = material.roughness;
  view.metallic_roughness_texture = texture_of(data, mesh, material.metallic_roughness_texture);
  view.normal_scale = material.normal_scale;
  view.normal_texture = texture_of(data, mesh, material.normal_texture);
  view.occlusion_strength = material.occlusion_strength;
  view.occlusion_texture = texture_of(data, mesh, material.occlusion_texture);
  view.emission_texture = texture_of(data, mesh, material.emission_texture);
}

anim::CharacterRigs rigs_of(const anim::Model& model, std::optional<anim::RagdollRig> ragdoll) {
  if (!ragdoll) return anim::CharacterRigs(model);
  return anim::CharacterRigs(model.skeleton, std::move(*ragdoll));
}

void drop_surface(anim::Model& model) {
  model.meshes.clear();
  model.mesh_lods.clear();
  model.parts.clear();
  model.materials.clear();
  model.images.clear();
}

}  // namespace

detail::CharacterBody::CharacterBody(anim::Model from, std::optional<anim::RagdollRig> ragdoll, bool keep_meshes)
    : rigs(rigs_of(from, std::move(ragdoll))), model(std::move(from)) {
  for (const anim::Morph& morph : model.morphs) morph_names.push_back(morph.name);
  model.skeleton = {};
  model.clips = {};
  if (!keep_meshes) drop_surface(model);
}

Character detail::character_of(anim::Character baked, std::shared_ptr<const CharacterBody> body) {
  auto shared = std::make_shared<const anim::Character>(std::move(baked));
  return Character(
      std::make_shared<const CharacterData>(CharacterData{.baked = std::move(shared), .body = std::move(body)}));
}

std::uint32_t Character::clip_count() const { return static_cast<std::uint32_t>(baked(data()).clips.size()); }

bool Character::has(ClipId clip) const {
  const auto& clips = baked(data()).clips;
  if (clip.number >= clips.size() || clips[clip.number].is_empty()) return false;
  return clip.generation == whichever || clip.generation == clips[clip.number].generation;
}

ClipInfo Character::clip(ClipId clip) const {
  if (!has(clip)) return {};
  const anim::Character& character = baked(data());
  const anim::BakedClip& own = character.clips[clip.number];
  return {.name = own.name, .duration = own.duration, .loops = own.loops, .ground_speed = own.ground_speed()};
}

ClipId Character::find_clip(std::string_view name) const {
  const auto& clips = baked(data()).clips;
  const auto is_named = [name](const anim::BakedClip& clip) { return !clip.is_empty() && clip.name == name; };
  const auto found = std::ranges::find_if(clips, is_named);
  if (found == clips.end()) return {};
  return {.number = static_cast<std::uint32_t>(found - clips.begin()), .generation = found->generation};
}

ClipId Character::find_role(std::string_view role) const {
  const std::optional<anim::ClipRole> wanted = anim::role_named(role);
  if (!wanted) {
    anim::report_misuse({"Character::find_role", "there is no role of this name; see the list in throng/character.h"});
    return {};
  }
  std::vector<std::string> names;
  for (const anim::BakedClip& clip : baked(data()).clips) names.push_back(clip.is_empty() ? std::string() : clip.name);
  const int found = anim::roles_of_clips(names)[static_cast<std::size_t>(*wanted)];
  if (found == anim::no_clip) return {};
  const auto number = static_cast<std::uint32_t>(found);
  return {.number = number, .generation = baked(data()).clips[number].generation};
}

Result<Character> Character::with_clips(const Character& more) const {
  if (!*this || !more) return anim::refuse({"Character::with_clips", "a character is empty"});
  Result<anim::Character> made = anim::with_clips(data()->baked, more.data()->baked);
  if (!made) return made.error();
  return detail::character_of(std::move(*made), data()->body);
}

Result<Character> Character::without(ClipId clip) const {
  if (!*this) return anim::refuse({"Character::without", "the character is empty"});
  if (!has(clip)) return Error{data()->baked->skeleton.name + ": the character has no clip of this id"};
  Result<anim::Character> made = anim::without_clip(data()->baked, static_cast<int>(clip.number));
  if (!made) return made.error();
  return detail::character_of(std::move(*made), data()->body);
}

int Character::bone_count() const { return baked(data()).skeleton.bone_count(); }

std::string_view Character::bone_name(int bone) const {
  const anim::Character& character = baked(data());
  return has_bone(character, bone) ? std::string_view(character.skeleton.bones[static_cast<std::size_t>(bone)].name)
                                   : std::string_view();
}

int Character::bone_parent(int bone) const {
  const anim::Character& character = baked(data());
  return has_bone(character, bone) ? character.skeleton.parent(bone) : -1;
}

std::optional<int> Character::find_bone(std::string_view name) const {
  const int bone = anim::find_bone(baked(data()).skeleton, name);
  return bone < 0 ? std::nullopt : std::optional(bone);
}

int Character::level_count() const { return static_cast<int>(baked(data()).level_entries.size()); }

std::uint32_t Character::palette_entries(int level) const {
  const auto& entries = baked(data()).level_entries;
  return level >= 0 && static_cast<std::size_t>(level) < entries.size() ? entries[static_cast<std::size_t>(level)] : 0;
}

std::vector<std::uint16_t> Character::entries_at_level(int level) const {
  std::vector<std::vector<std::uint16_t>> levels = anim::entries_at_levels(baked(data()).skeleton);
  const auto place = static_cast<std::size_t>(level);
  return level < 0 || place >= levels.size() ? std::vector<std::uint16_t>() : std::move(levels[place]);
}

std::vector<std::array<float, 4>> Character::packing_frames() const {
  std::vector<std::array<float, 4>> frames;
  for (const anim::PackingFrame& frame : anim::packing_frames(baked(data()).skeleton)) {
    frames.push_back({frame.pivot[0], frame.pivot[1], frame.pivot[2], frame.step});
  }
  return frames;
}

double Character::height() const { return baked(data()).height; }

std::span<const std::string> Character::data_key_names() const { return baked(data()).data_key_names; }

std::span<const std::string> Character::curve_names() const { return baked(data()).curve_names; }

std::size_t Character::mesh_count() const { return data() == nullptr ? 0 : data()->body->model.meshes.size(); }

MeshView Character::mesh(std::size_t index) const {
  if (index >= mesh_count()) return {};
  const anim::SkinnedMesh& mesh = data()->body->model.meshes[index];
  MeshView view;
  view.name = mesh.name;
  view.positions = as_floats<Vec3>(mesh.positions);
  view.normals = as_floats<Vec3>(mesh.normals);
  view.texture_coords = coords_of(mesh, 0);
  view.palette_entries = as_floats<std::array<std::uint16_t, 4>>(mesh.palette_entries);
  view.weights = as_floats<std::array<float, 4>>(mesh.weights);
  view.indices = mesh.indices;
  view.tangents = as_floats<std::array<float, 4>>(mesh.tangents);
  view.colors = as_floats<std::array<float, 4>>(mesh.colors);
  view.morph_deltas = as_floats<MorphDelta>(mesh.morph_deltas);
  show_material(*data()->body, mesh, view);
  return view;
}

std::span<const std::string> Character::morph_names() const {
  return data() == nullptr ? std::span<const std::string>() : data()->body->morph_names;
}

std::span<const std::string> Character::missing_rigs() const {
  return data() == nullptr ? std::span<const std::string>() : data()->body->rigs.missing();
}

}  // namespace throng
