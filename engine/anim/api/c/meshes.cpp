#include <algorithm>
#include <cstddef>

#include "engine/anim/api/c/parts.h"

namespace throng::c {

static_assert(THRONG_ALPHA_BLEND == static_cast<int>(AlphaMode::blend));
static_assert(offsetof(MorphDelta, morph) == offsetof(throng_morph_delta, morph));
static_assert(offsetof(MorphDelta, normal) == offsetof(throng_morph_delta, normal));
static_assert(sizeof(MorphDelta) == sizeof(throng_morph_delta));

namespace {

template <typename To, typename From>
const To* first_of(std::span<const From> elements) {
  return reinterpret_cast<const To*>(elements.data());
}

throng_texture texture_of(const TextureView& view) {
  return {
      .texels = view.texels.data(), .width = view.width, .height = view.height, .coords = first_of<float>(view.coords)};
}

void write_material(const MeshView& view, throng_mesh& mesh) {
  std::ranges::copy(view.base_color, mesh.base_color);
  std::ranges::copy(view.emission, mesh.emission);
  mesh.metallic = view.metallic;
  mesh.roughness = view.roughness;
  mesh.normal_scale = view.normal_scale;
  mesh.occlusion_strength = view.occlusion_strength;
  mesh.alpha_cutoff = view.alpha_cutoff;
  mesh.alpha = static_cast<uint32_t>(view.alpha);
  mesh.double_sided = view.double_sided ? 1 : 0;
  mesh.unlit = view.unlit ? 1 : 0;
  mesh.base_color_texels = view.base_color_texels.data();
  mesh.texture_width = view.texture_width;
  mesh.texture_height = view.texture_height;
  mesh.metallic_roughness_texture = texture_of(view.metallic_roughness_texture);
  mesh.normal_texture = texture_of(view.normal_texture);
  mesh.occlusion_texture = texture_of(view.occlusion_texture);
  mesh.emission_texture = texture_of(view.emission_texture);
}

throng_mesh mesh_of(const MeshView& view) {
  throng_mesh mesh{};
  mesh.vertex_count = static_cast<uint32_t>(view.positions.size());
  mesh.index_count = static_cast<uint32_t>(view.indices.size());
  mesh.morph_delta_count = static_cast<uint32_t>(view.morph_deltas.size());
  mesh.name = text_of(view.name);
  mesh.positions = first_of<float>(view.positions);
  mesh.normals = first_of<float>(view.normals);
  mesh.texture_coords = first_of<float>(view.texture_coords);
  mesh.palette_entries = first_of<uint16_t>(view.palette_entries);
  mesh.weights = first_of<float>(view.weights);
  mesh.indices = view.indices.data();
  mesh.tangents = first_of<float>(view.tangents);
  mesh.colors = first_of<float>(view.colors);
  mesh.morph_deltas = first_of<throng_morph_delta>(view.morph_deltas);
  write_material(view, mesh);
  return mesh;
}

/// Returns the texels of an image, four bytes each.
std::span<const std::uint8_t> texels_of(const std::uint8_t* texels, std::int32_t width, std::int32_t height) {
  if (texels == nullptr || width < 0 || height < 0) return {};
  return {texels, std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)};
}

TextureView texture_view_of(const throng_texture& texture, std::size_t vertices) {
  return {.texels = texels_of(texture.texels, texture.width, texture.height),
          .width = texture.width,
          .height = texture.height,
          .coords = elements<std::array<float, 2>>(texture.coords, vertices)};
}

void read_material(const throng_mesh& mesh, MeshView& view) {
  std::ranges::copy(mesh.base_color, view.base_color.begin());
  std::ranges::copy(mesh.emission, view.emission.begin());
  view.metallic = mesh.metallic;
  view.roughness = mesh.roughness;
  view.normal_scale = mesh.normal_scale;
  view.occlusion_strength = mesh.occlusion_strength;
  view.alpha_cutoff = mesh.alpha_cutoff;
  view.alpha = static_cast<AlphaMode>(mesh.alpha);
  view.double_sided = mesh.double_sided != 0;
  view.unlit = mesh.unlit != 0;
  view.base_color_texels = texels_of(mesh.base_color_texels, mesh.texture_width, mesh.texture_height);
  view.texture_width = mesh.texture_width;
  view.texture_height = mesh.texture_height;
  view.metallic_roughness_texture = texture_view_of(mesh.metallic_roughness_texture, mesh.vertex_count);
  view.normal_texture = texture_view_of(mesh.normal_texture, mesh.vertex_count);
  view.occlusion_texture = texture_view_of(mesh.occlusion_texture, mesh.vertex_count);
  view.emission_texture = texture_view_of(mesh.emission_texture, mesh.vertex_count);
}

MeshView mesh_view_of(const throng_mesh& mesh) {
  MeshView view;
  view.name = view_of(mesh.name);
  view.positions = elements<Vec3>(mesh.positions, mesh.vertex_count);
  view.normals = elements<Vec3>(mesh.normals, mesh.vertex_count);
  view.texture_coords = elements<std::array<float, 2>>(mesh.texture_coords, mesh.vertex_count);
  view.palette_entries = elements<std::array<std::uint16_t, 4>>(mesh.palette_entries, mesh.vertex_count);
  view.weights = elements<std::array<float, 4>>(mesh.weights, mesh.vertex_count);
  view.indices = elements<std::uint32_t>(mesh.indices, mesh.index_count);
  view.tangents = elements<std::array<float, 4>>(mesh.tangents, mesh.vertex_count);
  view.colors = elements<std::array<float, 4>>(mesh.colors, mesh.vertex_count);
  view.morph_deltas = as<const MorphDelta>(mesh.morph_deltas, mesh.morph_delta_count);
  read_material(mesh, view);
  return view;
}

/// Returns whether a mesh has the arrays that its counts ask for; else reports a misuse.
bool has_arrays(const Call& call, const throng_mesh& mesh) {
  return (mesh.vertex_count == 0 ||
          !call.is_missing(mesh.positions, mesh.normals, mesh.palette_entries, mesh.weights)) &&
         (mesh.index_count == 0 || !call.is_missing(mesh.indices)) &&
         (mesh.morph_delta_count == 0 || !call.is_missing(mesh.morph_deltas));
}

}  // namespace

template <>
throng_mesh default_of() {
  return mesh_of({});
}

}  // namespace throng::c

using namespace throng::c;  // NOLINT: functions of C have no namespace

int throng_mesh_fill(throng_mesh* into, size_t size) { return fill("throng_mesh_fill", into, size); }

uint32_t throng_character_mesh_count(const throng_character* character) {
  if (is_missing("throng_character_mesh_count", character)) return 0;
  return static_cast<uint32_t>(character->own.mesh_count());
}

int throng_character_mesh(const throng_character* character, uint32_t index, throng_mesh* mesh) {
  const Call call("throng_character_mesh");
  if (call.is_missing(character, mesh) || !call.read("throng_mesh", mesh)) return failed;
  if (index >= character->own.mesh_count()) {
    return fail("throng_character_mesh: there is no mesh of this number; throng_load_options::keep_meshes keeps them");
  }
  write_known(mesh_of(character->own.mesh(index)), mesh);
  return done;
}

int throng_builder_add_mesh(throng_builder* builder, const throng_mesh* mesh) {
  const Call call("throng_builder_add_mesh");
  if (call.is_missing(builder, mesh)) return failed;
  const auto read = call.read("throng_mesh", mesh);
  if (!read || !call.is_constant("throng_mesh::alpha", read->alpha, AlphaMode::blend) || !has_arrays(call, *read)) {
    return failed;
  }
  builder->own.add_mesh(mesh_view_of(*read));
  return call.outcome();
}
