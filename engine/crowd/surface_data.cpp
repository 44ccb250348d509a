#include "engine/crowd/surface_data.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/kernel/palette/hierarchy.h"
#include "engine/anim/rig/rig_map.h"
#include "engine/anim/survey/bone_lod.h"

namespace throng {
namespace {

template <typename Float, typename Vector>
std::span<const Float> flat(const std::vector<Vector>& vectors) {
  return {reinterpret_cast<const Float*>(vectors.data()), vectors.size() * sizeof(Vector) / sizeof(Float)};
}

std::span<const float> coords_of(const anim::SkinnedMesh& mesh, const anim::Texture& texture) {
  if (mesh.texture_coords.empty()) return {};
  return flat<float>(mesh.texture_coords[static_cast<std::size_t>(texture.coords)]);
}

// Returns the texture whose coordinates the material's other textures take, unless they have their own.
const anim::Texture& leading_texture(const anim::Material& material) {
  for (const anim::Texture* texture : {&material.base_color_texture, &material.emission_texture,
                                       &material.metallic_roughness_texture, &material.normal_texture}) {
    if (texture->image >= 0) return *texture;
  }
  return material.occlusion_texture;
}

render::TextureData texture_data(const anim::Texture& texture) {
  return {.image = texture.image,
          .wrap_u = static_cast<int>(texture.wrap_u),
          .wrap_v = static_cast<int>(texture.wrap_v),
          .magnified = static_cast<int>(texture.magnified),
          .minified = static_cast<int>(texture.minified)};
}

}  // namespace

render::MeshPartData part_data(const anim::SkinnedMesh& mesh, const anim::Material& material) {
  const anim::Texture& leading = leading_texture(material);
  const auto own_coords = [&](const anim::Texture& texture) {
    return texture.image < 0 || texture.coords == leading.coords ? std::span<const float>() : coords_of(mesh, texture);
  };
  return {.positions = flat<float>(mesh.positions),
          .normals = flat<float>(mesh.normals),
          .texture_coords = coords_of(mesh, leading),
          .emission_coords = own_coords(material.emission_texture),
          .metallic_roughness_coords = own_coords(material.metallic_roughness_texture),
          .normal_coords = own_coords(material.normal_texture),
          .occlusion_coords = own_coords(material.occlusion_texture),
          .tangents = flat<float>(mesh.tangents),
          .colors = flat<float>(mesh.colors),
          .regions = mesh.regions,
          .shapes = anim::find_channel(mesh, "_SHAPE"),
          .hair = anim::find_channel(mesh, "_HAIR"),
          .trims = anim::find_channel(mesh, "_TRIM"),
          .faces = anim::find_channel(mesh, "_FACE"),
          .palette_entries = flat<std::uint16_t>(mesh.palette_entries),
          .weights = flat<float>(mesh.weights),
          .indices = mesh.indices,
          .material = mesh.material};
}

namespace {

render::MaterialData material_data(const anim::Material& material) {
  const glm::vec4& color = material.base_color;
  const glm::vec3& emission = material.emission;
  return {.base_color = {color.r, color.g, color.b, color.a},
          .base_color_texture = texture_data(material.base_color_texture),
          .emission = {emission.r, emission.g, emission.b},
          .emission_texture = texture_data(material.emission_texture),
          .metallic = material.metallic,
          .roughness = material.roughness,
          .metallic_roughness_texture = texture_data(material.metallic_roughness_texture),
          .normal_scale = material.normal_scale,
          .normal_texture = texture_data(material.normal_texture),
          .occlusion_strength = material.occlusion_strength,
          .occlusion_texture = texture_data(material.occlusion_texture),
          .unlit = material.unlit,
          .double_sided = material.double_sided,
          .blended = material.blended,
          .alpha_cutoff = material.alpha_cutoff};
}

}  // namespace

void add_materials(std::span<const anim::Material> materials, std::span<const anim::Image> images,
                   render::CrowdMeshData& data) {
  for (const anim::Material& material : materials) data.materials.push_back(material_data(material));
  for (const anim::Image& image : images) {
    data.images.push_back({.width = image.width, .height = image.height, .rgba = image.rgba});
  }
}

void add_palette_data(const anim::Skeleton& skeleton, render::CrowdMeshData& data) {
  data.entry_at_level = anim::entries_at_levels(skeleton);
  for (const anim::PackingFrame& frame : anim::packing_frames(skeleton)) {
    data.packing_frames.push_back({{frame.pivot[0], frame.pivot[1], frame.pivot[2]}, frame.step});
  }
}

std::vector<render::MorphDeltaData> morph_deltas(std::span<const anim::SkinnedMesh> meshes) {
  std::vector<render::MorphDeltaData> deltas;
  std::uint32_t first = 0;  // vertex of the mesh
  for (const anim::SkinnedMesh& mesh : meshes) {
    for (const anim::MorphDelta& delta : mesh.morph_deltas) {
      deltas.push_back({.vertex = first + delta.vertex,
                        .morph = delta.morph,
                        .position = {delta.position.x, delta.position.y, delta.position.z},
                        .normal = {delta.normal.x, delta.normal.y, delta.normal.z}});
    }
    first += static_cast<std::uint32_t>(mesh.positions.size());
  }
  return deltas;
}

std::vector<std::uint8_t> face_entries(const anim::Skeleton& skeleton) {
  const int head = anim::find_rig(skeleton).at(anim::BodyRole::head);
  if (head < 0) return {};
  std::vector<std::uint8_t> of_head, entries;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const int parent = skeleton.bones[static_cast<std::size_t>(bone)].parent;
    const bool follows = parent >= 0 && of_head[static_cast<std::size_t>(parent)] != 0;
    of_head.push_back(bone == head || follows ? 1 : 0);
  }
  for (const anim::PaletteEntry& entry : skeleton.palette) {
    entries.push_back(of_head[static_cast<std::size_t>(entry.bone)]);
  }
  return entries;
}

std::vector<render::BoneEndData> bone_ends(const anim::Skeleton& skeleton) {
  std::vector<render::BoneEndData> ends;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const int parent = skeleton.bones[static_cast<std::size_t>(bone)].parent;
    const anim::JointPlace places[] = {anim::joint_place(skeleton, bone),
                                       anim::joint_place(skeleton, std::max(parent, 0))};
    if (parent < 0 || places[0].entry < 0 || places[1].entry < 0) continue;
    for (const anim::JointPlace& place : places) {
      const glm::vec3 position(place.position);
      ends.push_back({{position.x, position.y, position.z}, static_cast<std::uint16_t>(place.entry)});
    }
  }
  return ends;
}

}  // namespace throng
