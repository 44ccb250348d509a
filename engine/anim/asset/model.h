#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// A skin of the file and the palette entry that each of its joints reads. Lets poses be reported joint by joint.
struct Skin {
  int skin = -1;  ///< index in the file
  std::string name;
  std::vector<int> bones;                 ///< joint -> bone, in skin.joints order
  std::vector<int> palette_entries;       ///< joint -> palette entry, in skin.joints order
  std::vector<glm::dmat4> inverse_binds;  ///< as in the file; identity where it has none
  glm::dmat4 bind_to_model{1.0};          ///< rigid path: vertex space of the skin -> space of the palette.
                                          ///< scene palette = palette entry * bind_to_model
  std::vector<int> mesh_nodes;            ///< nodes that draw a mesh with this skin
};

struct Image {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> rgba;       ///< width * height * 4, top row first; sRGB where it is a colour
  std::shared_ptr<const void> lender = {};  ///< keeps the memory that `rgba` lies in
};

/// Says how a texture goes on outside of coordinates 0 to 1. The numbers are those of glTF 2.0, 5.26, and of OpenGL.
enum class Wrap : std::uint16_t { clamp = 33071, mirror = 33648, repeat = 10497 };

/// Says how a texture is read between its texels and, from `nearest_of_nearest` on, between its mip levels.
enum class Filter : std::uint16_t {
  nearest = 9728,
  linear = 9729,
  nearest_of_nearest = 9984,
  linear_of_nearest = 9985,
  nearest_of_linear = 9986,
  linear_of_linear = 9987
};

/// An image as one property of a material shows it.
struct Texture {
  int image = -1;  ///< index among Model::images; -1: no texture
  int coords = 0;  ///< index among SkinnedMesh::texture_coords
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  Filter magnified = Filter::linear;
  Filter minified = Filter::linear_of_linear;
};

/// A material (glTF 2.0, 3.9). Factors multiply what their textures show; a texture without an image shows 1.
struct Material {
  std::string name;
  glm::vec4 base_color{1.0F};  ///< linear
  Texture base_color_texture;  ///< sRGB, linear alpha
  glm::vec3 emission{0.0F};    ///< linear, 1: as bright as white of the screen
  Texture emission_texture;    ///< sRGB
  bool unlit = false;          ///< it shows its base colour, whatever the light
  bool double_sided = false;
  bool blended = false;       ///< it is seen through as far as its alpha is below 1
  float alpha_cutoff = 0.0F;  ///< less alpha is not seen; 0: opaque, unless `blended`
  float metallic = 1.0F;
  float roughness = 1.0F;
  Texture metallic_roughness_texture;  ///< linear, roughness in green, metallic in blue
  float normal_scale = 1.0F;
  Texture normal_texture;  ///< linear, in the space of SkinnedMesh::tangents
  float occlusion_strength = 1.0F;
  Texture occlusion_texture;  ///< linear, in red
};

/// A shape that clips add to the surface by a weight: a morph target of glTF (2.0, 3.7.2.2) that a clip animates.
struct Morph {
  std::string name;          ///< `mesh 0 "Body", target 2 "smile"`
  int node = -1;             ///< the node of the file that draws the mesh
  int target = 0;            ///< index among the targets of the mesh
  double rest_weight = 0.0;  ///< what the surface shows without animation
};

/// Holds the change that a morph of weight 1 makes to a vertex.
struct MorphDelta {
  std::uint32_t vertex = 0;
  std::uint32_t morph = 0;  ///< index among Model::morphs
  glm::vec3 position{0.0F};
  glm::vec3 normal{0.0F};
};

/// A vertex attribute that this library only carries, as the file has it.
struct VertexChannel {
  std::string name;  ///< of the attribute
  int components = 1;
  std::vector<float> values;  ///< [position][component]
};

/// One glTF primitive as triangles, skinned, in the space of the palette (see Skin::bind_to_model).
struct SkinnedMesh {
  std::string name;
  int material = 0;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;   ///< one a position; those of the triangles where the file has none
  std::vector<glm::vec4> tangents;  ///< where the material has a normal texture: one a position, w is the
                                    ///< side of the bitangent, -1 or 1; else empty
  std::vector<std::vector<glm::vec2>> texture_coords;  ///< by Texture::coords; one a position, or empty. A mesh with
                                                       ///< regions and no texture has its `TEXCOORD_0`
  std::vector<glm::vec4> colors;                       ///< linear RGBA, one a position, or empty
  std::vector<std::uint8_t> regions;          ///< `_REGION`: tint region 0..8, 5 untinted; one a position, or empty
  std::vector<VertexChannel> channels;        ///< the attributes of ImportOptions::channels that the file has
  std::vector<glm::u16vec4> palette_entries;  ///< four influences a position, strongest first
  std::vector<glm::vec4> weights;             ///< sum to 1; import drops and reports influences beyond four
  std::vector<std::uint32_t> indices;         ///< triangles, counter-clockwise front
  std::vector<MorphDelta> morph_deltas;       ///< of the vertices that morphs move: by vertex, then by morph
};

/// Returns the values of a mesh's channel, or nothing where the mesh lacks it. Points to the mesh.
inline std::span<const float> find_channel(const SkinnedMesh& mesh, std::string_view name) {
  const auto found = std::ranges::find(mesh.channels, name, &VertexChannel::name);
  return found == mesh.channels.end() ? std::span<const float>() : found->values;
}

/// A coarser surface from the file, with weights of its own.
struct BakedMeshLod {
  double error = 0.0;  ///< metres from the full surface, as the file says
  std::vector<SkinnedMesh> meshes;
};

/// A piece of what a character may wear or be made of. Each agent of a varied crowd wears some of them.
struct ModelPart {
  std::string name;                    ///< of its node, behind the first `/`
  std::string slot;                    ///< the slot that it fills, as "top"; empty: it is always worn
  std::string body;                    ///< the body that it fits, as "woman"; empty: all
  std::vector<std::string> covers;     ///< slots that are not drawn below it
  std::vector<std::string> keeps_out;  ///< slots that stay empty with it
  std::vector<std::string> tags;       ///< words for rules, as "warm"
  std::vector<SkinnedMesh> meshes;     ///< without morphs
  std::vector<BakedMeshLod> lods;      ///< finest first; may be empty
  double error = 0.0;                  ///< metres that a silhouette is off the outfit it stands for
};

/// The slot of parts that show a whole outfit from afar.
inline constexpr std::string_view silhouette_slot = "silhouette";

/// One skeleton of a file with its skins, clips, meshes and materials.
struct Model {
  Skeleton skeleton;
  std::vector<Skin> skins;
  std::vector<Clip> clips;
  std::vector<SkinnedMesh> meshes;
  std::vector<Morph> morphs;            ///< those that its clips animate
  std::vector<BakedMeshLod> mesh_lods;  ///< finest first; empty unless the file has them for all of `meshes`
  std::vector<ModelPart> parts;         ///< empty: all wear `meshes`; else these have the first part of each slot
  std::vector<Material> materials;      ///< at least one if there is a mesh
  std::vector<Image> images;
  bool faces_backwards = false;  ///< the file's format looks along -Z, as VRM 0.x does (see placement.h)
};

/// Calls `visit` with the meshes of a model, with those of each mesh LOD, and with those of each part and its LODs.
void visit_surfaces(auto& model, const auto& visit) {
  visit(model.meshes);
  for (auto& lod : model.mesh_lods) visit(lod.meshes);
  for (auto& part : model.parts) {
    visit(part.meshes);
    for (auto& lod : part.lods) visit(lod.meshes);
  }
}

/// The contents of one .glb or .gltf. Models are sorted by the number of vertices skinned to them, then by joints,
/// largest first.
struct ImportedFile {
  std::string file;
  std::vector<Model> models;            ///< at least one
  std::vector<std::string> animations;  ///< name of every animation of the file, by index
  std::vector<std::string> repairs;     ///< one sentence for each fault that import mended
  std::vector<std::string> notes;       ///< one sentence for each change of the models after import
};

}  // namespace throng::anim
