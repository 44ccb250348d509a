#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

namespace throng::render {

/// How far a coarser mesh is off, in metres, as MeshErrorMeter measures it.
struct MeshError {
  float surface = 0.0F;  ///< anywhere
  float face = 0.0F;     ///< on faces alone; the same where no face is known

  friend bool operator==(const MeshError&, const MeshError&) = default;
};

/// The meshes of a character, the full one first. The spans have one element a mesh.
struct MeshLodList {
  std::span<const MeshError> errors{};         ///< metres
  std::span<const std::uint32_t> triangles{};  ///< in each
};

/// Returns the coarsest mesh LOD whose errors are at most `limits`, in the unit of the errors. The first errors are 0.
inline int pick_mesh_lod(std::span<const MeshError> error_by_lod, const MeshError& limits) {
  assert(!error_by_lod.empty());
  std::size_t lod = error_by_lod.size() - 1;
  while (lod > 0 && (error_by_lod[lod].surface > limits.surface || error_by_lod[lod].face > limits.face)) --lod;
  return static_cast<int>(lod);
}

}  // namespace throng::render
