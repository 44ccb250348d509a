#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/crowd_mesh_data.h"
#include "engine/render/gl/handles.h"
#include "engine/render/mesh/surface.h"
#include "engine/result.h"

namespace throng::render {

/// One material on the device.
struct CrowdMaterial {
  float base_color[4];  ///< linear
  GLuint texture;       ///< sRGB; plain white where the character brings none
  bool double_sided;
  float alpha_cutoff;  ///< 0: opaque
};

/// Locations of the vertex attributes in `shaders/crowd_vertex.glsl`.
enum class SurfaceAttribute : GLuint { position, normal, texture_coord, color, weights, region, shape, hair };

/// Holds a character's surface on the device: vertices, the palette entries that they read at each bone level, mesh
/// LODs and materials.
class CrowdMesh {
 public:
  /// Fails where an image is larger than the device takes.
  static Result<CrowdMesh> create(const CrowdMeshData& data);

  std::size_t lod_count() const { return runs_by_lod_.size(); }
  std::size_t material_count() const { return materials_.size(); }
  std::span<const std::uint32_t> triangles_by_lod() const { return triangles_by_lod_; }
  std::span<const float> error_by_lod() const { return error_by_lod_; }  ///< metres

  /// Gives the runs that draw mesh LOD `lod`, one a material.
  std::span<const MaterialRun> runs(std::size_t lod) const { return runs_by_lod_[lod]; }
  const CrowdMaterial& material(int index) const { return materials_[static_cast<std::size_t>(index)]; }

  /// Binds the vertices and 32-bit indices and, for the program in use, the palette entries of all bone levels and the
  /// frames that unpack them.
  void bind() const;

  /// Counts the vertices of the full surface, which come first in the vertex array; those of baked mesh LODs follow.
  std::uint32_t vertex_count() const { return vertex_count_; }

  /// Name the ends of the bones' lines, two a bone, which come last.
  std::uint32_t first_bone_end() const { return first_bone_end_; }
  std::uint32_t bone_end_count() const { return bone_end_count_; }

 private:
  CrowdMesh() = default;

  gl::Buffer vertices_;
  gl::Buffer indices_;
  gl::Buffer palette_entries_;  // [bone level][vertex]
  gl::Buffer packing_frames_;   // [palette entry]
  gl::VertexArray array_;
  std::vector<std::vector<MaterialRun>> runs_by_lod_;
  std::vector<std::uint32_t> triangles_by_lod_;
  std::vector<float> error_by_lod_;
  std::vector<gl::Texture> textures_;
  std::vector<CrowdMaterial> materials_;
  std::uint32_t vertex_count_ = 0;
  std::uint32_t first_bone_end_ = 0;
  std::uint32_t bone_end_count_ = 0;
};

/// Is pick_mesh_lod of mesh_lod.h for the triangles of `mesh`.
int pick_mesh_lod(const CrowdMesh& mesh, float pixels_tall, int at_least, float detail);

}  // namespace throng::render
