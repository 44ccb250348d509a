#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "throng/render/crowd_mesh_data.h"
#include "throng/render/mesh_error_value.h"

namespace throng::render {

inline constexpr std::uint8_t untinted_region = 255;

/// Tells the vertex shader about a vertex; the palette entries that it reads are apart from it.
///
///      0  position x y z    space of the palette
///     12  normal x y z
///     24  texture coordinates u v
///     32  color r g b a     linear, 1 is 65535
///     40  weights           four, sum 65535
///     48  region            Region; any other is untinted
///     49  shape             shares of the look's build, frame and posture (AgentLook); 1 is 127
///     52  hair              shares of its fullness and length; 1 is 127
///     54  trim              share of the second colour in Pattern::trim; 1 is 255
///     55  unused
///     56  face              shares of the look's jaw, nose, brow and eyes; 1 is 127
struct SurfaceVertex {
  float position[3];
  float normal[3];
  float texture_coord[2];
  std::uint16_t color[4];
  std::uint16_t weights[4];
  std::uint8_t region;
  std::int8_t shape[3];
  std::int8_t hair[2];
  std::uint8_t trim;
  std::uint8_t unused;
  std::int8_t face[4];
};
static_assert(sizeof(SurfaceVertex) == 60);
static_assert(offsetof(SurfaceVertex, region) == 48);
static_assert(offsetof(SurfaceVertex, hair) == 52);
static_assert(offsetof(SurfaceVertex, trim) == 54);
static_assert(offsetof(SurfaceVertex, face) == 56);

using TextureCoord = std::array<float, 2>;

/// The coordinates u v at which a vertex reads the textures over the base colour.
struct DetailCoords {
  TextureCoord emission{};
  TextureCoord metallic_roughness{};
  TextureCoord normal{};
  TextureCoord occlusion{};
};
static_assert(sizeof(DetailCoords) == 32);

/// The direction in which the normal texture's u grows, 1 is 32767, and the side of the bitangent; 0 0 0: no bumps.
using PackedTangent = std::array<std::int16_t, 4>;

using PaletteEntries = std::array<std::uint16_t, 4>;

/// A run of indices that are drawn with one material.
struct MaterialRun {
  int material = 0;
  std::uint32_t first_index = 0;
  std::uint32_t index_count = 0;
};

/// The meshes of all of the character, or of a piece that some agents wear, finest first.
struct SurfacePiece {
  std::uint32_t first_lod = 0;                          ///< the mesh LOD that the finest stands for
  std::vector<std::vector<MaterialRun>> runs_by_level;  ///< at most one run a material
  std::vector<std::uint32_t> triangles_by_level;
  std::vector<MeshError> error_by_level;

  /// Returns the level that stands for a mesh LOD.
  std::size_t level_at(std::size_t lod) const {
    return std::min(lod - std::min<std::size_t>(lod, first_lod), runs_by_level.size() - 1);
  }
  /// Counts the mesh LODs up to the LOD that its coarsest level stands for.
  std::size_t lod_count() const { return std::min(first_lod + runs_by_level.size(), largest_mesh_lod_count); }
};

/// Says to which part each vertex and index of a surface belongs.
struct SurfaceParts {
  std::vector<SurfacePiece> pieces;  ///< [0] is all of the character
  std::uint32_t vertex_count = 0;    ///< vertices of the full surface, which come first; baked LODs and pieces follow
  std::uint32_t first_bone_end = 0;
  std::uint32_t bone_end_count = 0;
};

/// Holds all parts of a character in one set of vertices, ready to be copied to the device. The ends of the bones'
/// lines are vertices too, and come last.
struct Surface : SurfaceParts {
  std::vector<SurfaceVertex> vertices;
  std::vector<DetailCoords> detail_coords;  ///< one a vertex, or empty: the vertices' own texture coordinates
  std::vector<PackedTangent> tangents;      ///< one a vertex, or empty: no bumps
  std::vector<PaletteEntries> entries;      ///< [bone level][vertex]
  std::vector<std::uint32_t> indices;       ///< indices of all mesh LODs
};

/// Points to the arrays of a surface, wherever they lie.
struct SurfaceView : SurfaceParts {
  std::span<const SurfaceVertex> vertices;
  std::span<const DetailCoords> detail_coords;
  std::span<const PackedTangent> tangents;
  std::span<const PaletteEntries> entries;
  std::span<const std::uint32_t> indices;
};

/// Returns the view of a surface, which must outlive it.
SurfaceView view_of(const Surface& surface);

/// Merges the parts, simplifies them and sorts them by material. It asserts that the spans of a part fit each other and
/// that indices and entries are in range.
Surface build_surface(const CrowdMeshData& data);

}  // namespace throng::render
