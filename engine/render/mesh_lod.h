#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/surface_simplifier.h"

namespace throng::render {

/// At most this many mesh LODs, at about 100%, 30%, 10% and 3% of the triangles.
inline constexpr std::size_t largest_mesh_lod_count = 4;

/// One mesh LOD: triangles of the original vertices, so that weights stay valid.
struct MeshLod {
  std::vector<std::uint32_t> indices;
  float error = 0.0F;  ///< metres (the unit of the positions), the largest distance moved
};

/// Simplifies a surface step by step (SurfaceSimplifier; where it does not reach a step, because a character has many
/// loose pieces and no texture, meshoptimizer's clustering). [0] is the surface itself; each further LOD has clearly
/// fewer triangles than the one before, so a small mesh has fewer LODs. Never empty.
std::vector<MeshLod> build_mesh_lods(const SkinnedSurfaceView& surface);

/// The coarsest mesh LOD, not finer than `at_least`, whose triangles are still in proportion to the pixels that they
/// cover. `triangles_by_lod` descends. `detail` scales the number wanted: 1 gives a triangle to about every 5 pixels
/// covered.
int pick_mesh_lod(std::span<const std::uint32_t> triangles_by_lod, float pixels_tall, int at_least, float detail);

}  // namespace throng::render
