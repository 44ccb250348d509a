#pragma once

#include <cstdint>
#include <span>

#include "throng/render/crowd_mesh_data.h"

#include "engine/base/result.h"
#include "engine/render/gl/handles.h"
#include "engine/render/mesh/material.h"
#include "engine/render/mesh/surface.h"

namespace throng::render {

/// Holds a character's surface on the device: vertices, the palette entries that they read at each bone level, mesh
/// LODs and materials.
class CrowdMesh {
 public:
  /// Makes a mesh on the device. Errors: an image is larger than the device takes, or a packed surface is damaged.
  static Result<CrowdMesh> create(const CrowdMeshData& data);

  /// These three functions tell of piece 0: all of the character.
  std::size_t lod_count() const { return lod_count(0); }
  std::span<const std::uint32_t> triangles_by_lod() const { return piece(0).triangles_by_level; }
  std::span<const MeshError> error_by_lod() const { return piece(0).error_by_level; }

  /// Counts its pieces, all of the character among them.
  std::size_t piece_count() const { return parts_.pieces.size(); }
  /// Counts the mesh LODs of a piece. Its coarsest mesh stands for all that follow.
  std::size_t lod_count(std::size_t number) const { return piece(number).lod_count(); }
  /// Gives the runs that draw a piece at a mesh LOD, one a material.
  std::span<const MaterialRun> runs(std::size_t number, std::size_t lod) const {
    return piece(number).runs_by_level[piece(number).level_at(lod)];
  }
  std::uint32_t triangles(std::size_t number, std::size_t lod) const {
    return piece(number).triangles_by_level[piece(number).level_at(lod)];
  }
  const MeshError& error(std::size_t number, std::size_t lod) const {
    return piece(number).error_by_level[piece(number).level_at(lod)];
  }
  /// Returns the coarsest mesh LOD of a piece that is off by at most so many metres, or its finest.
  int coarsest_lod(std::size_t number, float metres) const;
  const MaterialSet& materials() const { return materials_; }

  /// Says whether morphs move some of its vertices.
  bool has_morphs() const { return static_cast<bool>(morph_entries_); }

  /// Binds the vertices and 32-bit indices and, for the program in use, the palette entries of all bone levels, the
  /// frames that unpack them, and the effects of morphs.
  void bind() const;

  /// Counts the vertices of the full surface, which come first in the vertex array; vertices of baked mesh LODs follow.
  std::uint32_t vertex_count() const { return parts_.vertex_count; }

  /// These two functions name the ends of the bones' lines, two a bone, which come last.
  std::uint32_t first_bone_end() const { return parts_.first_bone_end; }
  std::uint32_t bone_end_count() const { return parts_.bone_end_count; }
  /// Gives a radius, in metres of an agent of scale 1, around the place where an agent stands that holds its surface,
  /// stretched as far as poses stretch it: of piece 0, or of any piece.
  float reach(bool of_any_piece) const { return of_any_piece ? reach_of_pieces_ : reach_; }

  /// Gives the longest side of the box around them at rest, in metres; 0 without bones.
  float longest_side_of_bones() const { return longest_side_of_bones_; }

 private:
  CrowdMesh() = default;
  const SurfacePiece& piece(std::size_t number) const { return parts_.pieces[number]; }
  void copy_to_device(const SurfaceView& surface, std::span<const MorphDeltaData> morph_deltas);
  void create_morphs(std::span<const MorphDeltaData> deltas, std::size_t vertex_count);

  gl::Buffer vertices_;
  gl::Buffer detail_coords_;  // these two have names only where the surface has such
  gl::Buffer tangents_;
  gl::Buffer indices_;
  gl::Buffer palette_entries_;  // [bone level][vertex]
  gl::Buffer packing_frames_;   // [palette entry]
  gl::Buffer morph_firsts_;     // [vertex]; these two have names only where morphs move the surface
  gl::Buffer morph_entries_;
  gl::VertexArray array_;
  SurfaceParts parts_;
  float longest_side_of_bones_ = 0.0F;
  float reach_ = 0.0F, reach_of_pieces_ = 0.0F;
  float body_size_ = 1.0F;
  MaterialSet materials_;
};

}  // namespace throng::render
