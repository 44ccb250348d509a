#pragma once

#include <cstdint>
#include <string>
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
  std::vector<std::uint8_t> rgba;  ///< width * height * 4, sRGB, top row first
};

struct Material {
  std::string name;
  glm::vec4 base_color{1.0F};  ///< linear
  int image = -1;              ///< base colour texture among Model::images, or -1
  bool double_sided = false;
  float alpha_cutoff = 0.0F;  ///< 0: opaque
};

/// One glTF primitive as triangles, skinned, in the space of the palette (see Skin::bind_to_model).
struct SkinnedMesh {
  std::string name;
  int material = 0;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;             ///< one a position; computed where the file has none
  std::vector<glm::vec2> texture_coords;      ///< one a position, or empty
  std::vector<glm::vec4> colors;              ///< linear RGBA, one a position, or empty
  std::vector<std::uint8_t> regions;          ///< `_REGION`: tint region 0..4, or 5: untinted; one a position, or empty
  std::vector<glm::vec3> shapes;              ///< `_SHAPE`: stout, broad, stooped, -1..1; one a position, or empty
  std::vector<glm::vec2> hair;                ///< `_HAIR`: full, long, -1..1; one a position, or empty
  std::vector<glm::u16vec4> palette_entries;  ///< four influences a position, strongest first
  std::vector<glm::vec4> weights;             ///< sum to 1; import drops and reports influences beyond four
  std::vector<std::uint32_t> indices;         ///< triangles, counter-clockwise front
};

/// A coarser surface from the file, with weights of its own.
struct BakedMeshLod {
  double error = 0.0;  ///< metres from the full surface, as the file says
  std::vector<SkinnedMesh> meshes;
};

/// One skeleton of a file with its skins, clips, meshes and materials.
struct Model {
  Skeleton skeleton;
  std::vector<Skin> skins;
  std::vector<Clip> clips;
  std::vector<SkinnedMesh> meshes;
  std::vector<BakedMeshLod> mesh_lods;  ///< finest first; empty unless the file has them for all of `meshes`
  std::vector<Material> materials;      ///< at least one if there is a mesh
  std::vector<Image> images;
  bool faces_backwards = false;  ///< the file's format looks along -Z, as VRM 0.x does (see model_space.h)
};

/// The contents of one .glb or .gltf. Models are sorted by the number of vertices skinned to them, then by joints,
/// largest first.
struct ImportedFile {
  std::string file;
  std::vector<Model> models;            ///< at least one
  std::vector<std::string> animations;  ///< name of every animation of the file, by index
  std::vector<std::string> repairs;     ///< one sentence each: what import found odd and mended
};

}  // namespace throng::anim
