#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/crowd_mesh_data.h"
#include "engine/render/gl/handles.h"
#include "engine/render/mesh/material.h"
#include "engine/render/mesh/surface.h"
#include "engine/result.h"

namespace throng::render {

/// Holds a character's surface on the device: vertices, the palette entries that they read at each bone level, mesh
/// LODs and materials.
class CrowdMesh {
 public:
  /// Makes a mesh on the device. Errors: an image is larger than the device takes, or a packed surface is damaged.
  static Result<CrowdMesh> create(const CrowdMeshData& data);

  std::size_t lod_count() const { return parts_.runs_by_lod.size(); }
  /// Counts the triangles of piece 0.
  std::span<const std::uint32_t> triangles_by_lod() const { return parts_.triangles_by_lod; }
  /// Gives the largest errors of all pieces that are drawn at a mesh LOD.
  std::span<const MeshError> error_by_lod() const { return parts_.error_by_lod; }

  /// Gives the runs that draw a piece at a mesh LOD, one a material.
  std::span<const MaterialRun> runs(std::size_t piece, std::size_t lod) const {
    if (piece == 0) return parts_.runs_by_lod[lod];
    const SurfacePiece& of_outfits = parts_.pieces[piece - 1];
    return of_outfits.runs_by_level[of_outfits.level_at(lod)];
  }
  /// Counts its triangles.
  std::uint32_t triangles(std::size_t piece, std::size_t lod) const {
    if (piece == 0) return parts_.triangles_by_lod[lod];
    const SurfacePiece& of_outfits = parts_.pieces[piece - 1];
    return of_outfits.triangles_by_level[of_outfits.level_at(lod)];
  }
  /// Counts its pieces, all of the character among them.
  std::size_t piece_count() const { return parts_.pieces.size() + 1; }
  const MaterialSet& materials() const { return materials_; }

  /// Says whether morphs move some of its vertices.
  bool has_morphs() const { return static_cast<bool>(morph_entries_); }

  /// Binds the vertices and 32-bit indices and, for the program in use, the palette entries of all bone levels, the
  /// frames that unpack them, and what morphs do.
  void bind() const;

  /// Counts the vertices of the full surface, which come first in the vertex array; those of baked mesh LODs follow.
  std::uint32_t vertex_count() const { return parts_.vertex_count; }

  /// These two functions name the ends of the bones' lines, two a bone, which come last.
  std::uint32_t first_bone_end() const { return parts_.first_bone_end; }
  std::uint32_t bone_end_count() const { return parts_.bone_end_count; }
  /// Gives a radius, in metres of an agent of scale 1, around the place where an agent stands that holds its surface,
  /// stretched as far as poses stretch it.
  float reach() const { return reach_; }

  /// Gives the longest side of the box around them at rest, in metres; 0 without bones.
  float longest_side_of_bones() const { return longest_side_of_bones_; }

 private:
  CrowdMesh() = default;
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
  float reach_ = 0.0F;
  float body_size_ = 1.0F;
  MaterialSet materials_;
};

}  // namespace throng::render
