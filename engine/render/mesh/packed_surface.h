#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/render/mesh/surface.h"

namespace throng::render {

/// A surface as one relocatable block, whose arrays are copied to the device from where they lie:
///
///     PackedSurface | vertices | detail coordinates | tangents | entries | indices | runs | pieces | LODs
///
///      0        4                 8       12       16      20         24     28             32               36
///     | layout | detail coords   | levels | indices | runs | vertices | LODs | vertex_count | first_bone_end | ...
///
/// Each array begins at a multiple of 16 bytes.
struct alignas(16) PackedSurface {
  std::uint32_t layout;         ///< packed_surface_layout
  std::uint32_t detail_coords;  ///< counts of the elements of each array
  std::uint32_t levels;         ///< of which each has as many entries as there are vertices
  std::uint32_t indices;
  std::uint32_t runs;  ///< of all LODs and then of all levels of pieces, one after the other
  std::uint32_t vertices;
  std::uint32_t lods;          ///< of piece 0; the levels of all others follow
  std::uint32_t vertex_count;  ///< as in SurfaceParts, like the two that follow
  std::uint32_t first_bone_end;
  std::uint32_t bone_end_count;
  std::uint32_t tangents;
  std::uint32_t pieces;
};
static_assert(sizeof(PackedSurface) == 48);
static_assert(offsetof(PackedSurface, vertices) == 20);
static_assert(offsetof(PackedSurface, first_bone_end) == 32);

/// Describes a mesh LOD, or a level of a piece, of a packed surface.
struct PackedSurfaceLod {
  std::uint32_t runs;
  std::uint32_t triangles;
  MeshError error;
};

/// Describes a piece of a packed surface.
struct PackedSurfacePiece {
  std::uint32_t first_lod;
  std::uint32_t levels;
};

/// Changes with the sizes of the parts of a packed surface. Raise the first number when only a meaning changes.
inline constexpr std::uint32_t packed_surface_layout =
    3U << 24U | sizeof(SurfaceVertex) << 16U | sizeof(MaterialRun) << 8U | sizeof(PackedSurfaceLod);

/// Packs a surface. The same surface gives the same bytes.
std::vector<std::byte> pack_surface(const SurfaceView& surface);

/// Returns the view of a packed surface, which begins at a multiple of 16 bytes and must outlive it. Errors: it is of
/// another version, or damaged.
Result<SurfaceView> view_packed_surface(std::span<const std::byte> packed);

/// Returns the parts of a character's packed surface or, without one, of a surface that is built. Errors: those of
/// view_packed_surface.
Result<SurfaceParts> surface_parts(const CrowdMeshData& data);

}  // namespace throng::render
