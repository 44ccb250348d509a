#include "throng/character_builder.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "engine/anim/api/character_data.h"
#include "engine/anim/api/chosen_rig.h"
#include "engine/anim/api/crowd_parts.h"
#include "engine/anim/asset/model_check.h"
#include "engine/anim/asset/placement.h"
#include "engine/anim/asset/reference_frames.h"
#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/asset/skeleton_order.h"
#include "engine/anim/base/finite.h"
#include "engine/anim/base/misuse.h"
#include "engine/anim/survey/bone_importance.h"
#include "engine/base/text/plain_text.h"

namespace throng {

/// The model as far as it was told, in the order and the spaces of the host. Faults of calls that it cannot hold, such
/// as a bone that is not there, are kept in words.
struct detail::BuilderData {
  anim::Model model;
  std::vector<std::optional<glm::dmat4>> inverse_binds;  // [bone]
  std::string fault;                                     // the first one; empty: none so far
};

namespace {

using detail::BuilderData;

/// Returns what a builder was told; null, after a report, if it was moved from.
BuilderData* data_of(const std::unique_ptr<BuilderData>& data, const char* call) {
  if (data == nullptr) anim::report_misuse({call, detail::was_moved_from});
  return data.get();
}

void note_fault(BuilderData& data, const std::string& fault) {
  if (data.fault.empty()) data.fault = fault;
}

std::string in_marks(std::string_view name) { return "\"" + plain_text(name) + "\""; }

anim::Interpolation interpolation_of(KeyForm form) {
  if (form == KeyForm::step) return anim::Interpolation::step;
  return form == KeyForm::linear ? anim::Interpolation::linear : anim::Interpolation::cubic_spline;
}

glm::vec3 as_glm(const Vec3& v) { return {v.x, v.y, v.z}; }
glm::quat as_glm(const Quat& q) { return {q.w, q.x, q.y, q.z}; }

template <typename To, typename Value>
anim::Track<To> track_of(const BoneKeys<Value>& keys) {
  anim::Track<To> track{
      .interpolation = interpolation_of(keys.form), .times = {keys.seconds.begin(), keys.seconds.end()}, .values = {}};
  for (const Value& value : keys.values) track.values.push_back(as_glm(value));
  return track;
}

anim::Clip* clip_at(BuilderData& data, int clip) {
  if (clip >= 0 && static_cast<std::size_t>(clip) < data.model.clips.size())
    return &data.model.clips[static_cast<std::size_t>(clip)];
  note_fault(data, "there is no clip " + std::to_string(clip) + ": add_clip() returns the numbers of clips");
  return nullptr;
}

/// Returns the tracks of a bone in a clip, which stay ascending by bone; null and a fault where one is not there.
anim::BoneTracks* tracks_at(BuilderData& data, int clip, int bone) {
  anim::Clip* const of = clip_at(data, clip);
  if (of == nullptr) return nullptr;
  if (bone < 0 || bone >= data.model.skeleton.bone_count()) {
    note_fault(data, "clip " + in_marks(of->name) + ": there is no bone " + std::to_string(bone));
    return nullptr;
  }
  const auto place = std::ranges::lower_bound(of->tracks, bone, {}, &anim::BoneTracks::bone);
  if (place != of->tracks.end() && place->bone == bone) return &*place;
  anim::BoneTracks tracks;
  tracks.bone = bone;
  return &*of->tracks.insert(place, std::move(tracks));
}

/// Returns one inverse bind matrix a bone. Bones without one were bound in the rest pose.
/// Errors: the rest pose of a bone shrinks it to nothing, or a matrix is not of finite numbers.
Result<std::vector<glm::dmat4>> inverse_binds_of(const BuilderData& data) {
  const std::vector<glm::dmat4> globals = anim::reference_pose(data.model.skeleton, nullptr, 0.0).globals;
  std::vector<glm::dmat4> matrices;
  for (std::size_t bone = 0; bone < globals.size(); ++bone) {
    const std::optional<glm::dmat4>& own = data.inverse_binds[bone];
    const glm::dmat4& matrix = matrices.emplace_back(own ? *own : glm::inverse(globals[bone]));
    if (anim::all_finite(matrix)) continue;
    const std::string which = "bone " + in_marks(data.model.skeleton.bones[bone].name);
    return Error{which + (own ? ": its inverse_bind is not of finite numbers"
                              : ": its rest pose has a scale of 0, which has no inverse; give it an inverse_bind")};
  }
  return matrices;
}

/// Adds what a model of bones without levels, references and palette lacks to be checked: each bone has an entry of its
/// own, and nothing is rigid.
void make_checkable(anim::Skeleton& skeleton) {
  skeleton.rigid = false;
  skeleton.references.assign(skeleton.bones.size(), {});
  skeleton.level_bone_counts = {skeleton.bone_count()};
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) skeleton.palette.push_back({.bone = bone});
}

void bring_to_palette(anim::SkinnedMesh& mesh, const anim::Skin& skin) {
  const glm::dmat3 turn = glm::dmat3(skin.bind_to_model);
  for (glm::vec3& position : mesh.positions) {
    position = glm::vec3(skin.bind_to_model * glm::dvec4(glm::dvec3(position), 1.0));
  }
  for (glm::vec3& normal : mesh.normals) normal = glm::vec3(glm::normalize(turn * glm::dvec3(normal)));
  for (glm::vec4& tangent : mesh.tangents) {
    tangent = glm::vec4(glm::vec3(glm::normalize(turn * glm::dvec3(tangent))), tangent.w);
  }
  for (glm::u16vec4& bones : mesh.palette_entries) {
    for (int i = 0; i < 4; ++i) bones[i] = static_cast<std::uint16_t>(skin.palette_entries[bones[i]]);
  }
}

/// Makes a model of a checked one: references, palette, and an order of bones for level of detail.
void finish(anim::Model& model, std::vector<glm::dmat4> inverse_binds) {
  anim::Skin& skin = model.skins.emplace_back();
  skin.skin = 0;
  skin.name = model.skeleton.name;
  for (int bone = 0; bone < model.skeleton.bone_count(); ++bone) skin.bones.push_back(bone);
  skin.inverse_binds = std::move(inverse_binds);
  model.skeleton.palette.clear();
  anim::set_reference_frames(model.skeleton, model.skins, model.clips, {});
  for (anim::SkinnedMesh& mesh : model.meshes) bring_to_palette(mesh, model.skins.front());
  std::vector<int> parents;
  for (const anim::Bone& bone : model.skeleton.bones) parents.push_back(bone.parent);
  anim::reorder_bones(model, anim::order_bones(parents, anim::bone_importance(model)));
}

template <typename To, typename From>
std::vector<To> copied(std::span<const From> from) {
  static_assert(sizeof(To) == sizeof(From));
  std::vector<To> to(from.size());
  if (!from.empty()) std::memcpy(static_cast<void*>(to.data()), from.data(), from.size_bytes());
  return to;
}

/// Adds the texels of a texture as an image of its own, and its coordinates as a set of the mesh.
anim::Texture add_texture(const TextureView& view, anim::Model& model, anim::SkinnedMesh& mesh) {
  anim::Texture texture;
  texture.coords = static_cast<int>(mesh.texture_coords.size());
  if (!view.coords.empty()) mesh.texture_coords.push_back(copied<glm::vec2>(view.coords));
  if (view.texels.empty()) return texture;
  auto texels = std::make_shared<const std::vector<std::uint8_t>>(view.texels.begin(), view.texels.end());
  model.images.push_back({.width = view.width, .height = view.height, .rgba = *texels, .lender = texels});
  texture.image = static_cast<int>(model.images.size()) - 1;
  return texture;
}

/// Returns the five textures of a mesh; the first is its base colour.
std::array<TextureView, 5> textures_of(const MeshView& mesh) {
  const TextureView base_color{.texels = mesh.base_color_texels,
                               .width = mesh.texture_width,
                               .height = mesh.texture_height,
                               .coords = mesh.texture_coords};
  return {base_color, mesh.metallic_roughness_texture, mesh.normal_texture, mesh.occlusion_texture,
          mesh.emission_texture};
}

anim::Material material_of(const MeshView& view, anim::Model& model, anim::SkinnedMesh& mesh) {
  anim::Material material;
  material.name = view.name;
  for (int i = 0; i < 4; ++i) material.base_color[i] = view.base_color[static_cast<std::size_t>(i)];
  for (int i = 0; i < 3; ++i) material.emission[i] = view.emission[static_cast<std::size_t>(i)];
  material.blended = view.alpha == AlphaMode::blend;
  material.alpha_cutoff = view.alpha == AlphaMode::mask ? view.alpha_cutoff : 0.0F;
  material.double_sided = view.double_sided;
  material.unlit = view.unlit;
  material.metallic = view.metallic;
  material.roughness = view.roughness;
  material.normal_scale = view.normal_scale;
  material.occlusion_strength = view.occlusion_strength;
  const auto textures = textures_of(view);
  anim::Texture* const places[] = {&material.base_color_texture, &material.metallic_roughness_texture,
                                   &material.normal_texture, &material.occlusion_texture, &material.emission_texture};
  for (std::size_t i = 0; i < textures.size(); ++i) *places[i] = add_texture(textures[i], model, mesh);
  return material;
}

/// Says what a mesh lacks, in words; nothing if it is whole.
std::string fault_of(const MeshView& mesh) {
  const std::size_t count = mesh.positions.size();
  const auto is_one_each = [count](std::size_t elements) { return elements == 0 || elements == count; };
  if (mesh.normals.size() != count || mesh.palette_entries.size() != count || mesh.weights.size() != count) {
    return "it does not have one normal, one list of weights and one of bones a position";
  }
  if (!is_one_each(mesh.tangents.size()) || !is_one_each(mesh.colors.size())) {
    return "it does not have one tangent and one colour a position, or none";
  }
  for (const TextureView& texture : textures_of(mesh)) {
    const auto texels =
        static_cast<std::size_t>(std::max(texture.width, 0)) * static_cast<std::size_t>(std::max(texture.height, 0));
    if (texture.texels.size() != 4 * texels) return "its texels are not 4 bytes times width times height";
    if (!is_one_each(texture.coords.size()) || (texture.coords.empty() && !texture.texels.empty())) {
      return "a texture does not have one place a position";
    }
  }
  return {};
}

anim::SkinnedMesh copied(const MeshView& view) {
  anim::SkinnedMesh mesh;
  mesh.name = view.name;
  mesh.positions = copied<glm::vec3>(view.positions);
  mesh.normals = copied<glm::vec3>(view.normals);
  mesh.tangents = copied<glm::vec4>(view.tangents);
  mesh.colors = copied<glm::vec4>(view.colors);
  mesh.palette_entries = copied<glm::u16vec4>(view.palette_entries);
  mesh.weights = copied<glm::vec4>(view.weights);
  mesh.indices.assign(view.indices.begin(), view.indices.end());
  return mesh;
}

}  // namespace

CharacterBuilder::CharacterBuilder(std::string_view name) : data_(std::make_unique<detail::BuilderData>()) {
  data_->model.skeleton.name = name;
}

CharacterBuilder::CharacterBuilder(CharacterBuilder&& other) noexcept = default;
CharacterBuilder& CharacterBuilder::operator=(CharacterBuilder&& other) noexcept = default;
CharacterBuilder::~CharacterBuilder() = default;

int CharacterBuilder::add_bone(const BoneToBuild& bone) {
  BuilderData* const data = data_of(data_, "CharacterBuilder::add_bone");
  if (data == nullptr) return -1;
  std::vector<anim::Bone>& bones = data->model.skeleton.bones;
  const int index = static_cast<int>(bones.size());
  anim::Bone& added = bones.emplace_back();
  added.name = bone.name;
  added.node = index;
  added.parent = bone.parent;
  added.rest = {as_glm(bone.rest.translation), as_glm(bone.rest.rotation), as_glm(bone.rest.scale)};
  added.role = anim::body_role_named(bone.role);
  if (!bone.role.empty() && !added.role) {
    note_fault(*data, "bone " + in_marks(bone.name) + ": VRM 1.0 has no part of the body named " + in_marks(bone.role));
  }
  data->inverse_binds.emplace_back();
  if (bone.inverse_bind) data->inverse_binds.back() = glm::dmat4(glm::make_mat4(&bone.inverse_bind->columns[0][0]));
  return index;
}

int CharacterBuilder::add_clip(std::string_view name, double seconds) {
  BuilderData* const data = data_of(data_, "CharacterBuilder::add_clip");
  if (data == nullptr) return -1;
  anim::Clip& clip = data->model.clips.emplace_back();
  clip.name = name;
  clip.animation = static_cast<int>(data->model.clips.size()) - 1;
  clip.duration = seconds;
  return clip.animation;
}

void CharacterBuilder::set_translations(int clip, int bone, const BoneKeys<Vec3>& keys) {
  BuilderData* const data = data_of(data_, "CharacterBuilder::set_translations");
  if (data == nullptr) return;
  if (anim::BoneTracks* const tracks = tracks_at(*data, clip, bone)) tracks->translation = track_of<glm::vec3>(keys);
}

void CharacterBuilder::set_rotations(int clip, int bone, const BoneKeys<Quat>& keys) {
  BuilderData* const data = data_of(data_, "CharacterBuilder::set_rotations");
  if (data == nullptr) return;
  if (anim::BoneTracks* const tracks = tracks_at(*data, clip, bone)) tracks->rotation = track_of<glm::quat>(keys);
}

void CharacterBuilder::set_scales(int clip, int bone, const BoneKeys<Vec3>& keys) {
  BuilderData* const data = data_of(data_, "CharacterBuilder::set_scales");
  if (data == nullptr) return;
  if (anim::BoneTracks* const tracks = tracks_at(*data, clip, bone)) tracks->scale = track_of<glm::vec3>(keys);
}

void CharacterBuilder::add_data_key(int clip, std::string_view name, double seconds) {
  BuilderData* const data = data_of(data_, "CharacterBuilder::add_data_key");
  if (data == nullptr) return;
  anim::Clip* const of = clip_at(*data, clip);
  if (of == nullptr) return;
  const auto after = std::ranges::upper_bound(of->data_keys, seconds, {}, &anim::NamedDataKey::time);
  of->data_keys.insert(after, {.time = seconds, .name = std::string(name)});
}

void CharacterBuilder::add_curve(int clip, std::string_view name, std::span<const float> seconds,
                                 std::span<const float> values) {
  BuilderData* const data = data_of(data_, "CharacterBuilder::add_curve");
  if (data == nullptr) return;
  anim::Clip* const of = clip_at(*data, clip);
  if (of == nullptr) return;
  of->curves.push_back(
      {.name = std::string(name), .times = {seconds.begin(), seconds.end()}, .values = {values.begin(), values.end()}});
}

void CharacterBuilder::add_mesh(const MeshView& mesh) {
  BuilderData* const data = data_of(data_, "CharacterBuilder::add_mesh");
  if (data == nullptr) return;
  if (const std::string fault = fault_of(mesh); !fault.empty()) {
    return note_fault(*data, "mesh " + in_marks(mesh.name) + ": " + fault);
  }
  anim::Model& model = data->model;
  anim::SkinnedMesh& added = model.meshes.emplace_back(copied(mesh));
  added.material = static_cast<int>(model.materials.size());
  model.materials.push_back(material_of(mesh, model, added));
}

Result<LoadedFile> CharacterBuilder::build(const LoadOptions& options) const {
  if (data_ == nullptr) return anim::refuse({"CharacterBuilder::build", detail::was_moved_from});
  const std::string name = plain_text(data_->model.skeleton.name);
  if (!data_->fault.empty()) return Error{name + ": " + data_->fault};
  if (const Status valid = detail::check_options(name, options); !valid) return valid.error();
  anim::Model model = data_->model;
  make_checkable(model.skeleton);
  if (const Status valid = anim::check_model(model); !valid) return valid.error();
  detail::ChosenRig rig(options.rig);
  rig.give_to(model.skeleton);
  if (const Status given = rig.outcome(name); !given) return given.error();
  Result<std::vector<glm::dmat4>> inverse_binds = inverse_binds_of(*data_);
  if (!inverse_binds) return Error{name + ": " + inverse_binds.error().message};
  finish(model, std::move(*inverse_binds));
  anim::Placement placement;
  if (options.scale > 0.0) placement.scale = options.scale;
  anim::place_model(model, placement);
  LoadedFile built;
  if (const Status valid = anim::check_model(model); !valid) return valid.error();
  anim::Character baked = detail::bake(model, options);
  detail::add_character(std::move(model), {}, std::move(baked), options, built);
  return built;
}

}  // namespace throng
