#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/mesh/surface_simplifier.h"

namespace throng::render {

/// The most mesh LODs, at about 100%, 30%, 10% and 3% of the triangles.
inline constexpr std::size_t largest_mesh_lod_count = 4;

/// One mesh LOD: triangles over the original vertices, so that weights stay valid.
struct MeshLod {
  std::vector<std::uint32_t> indices;
  float error = 0.0F;  ///< metres (the unit of the positions), the largest distance moved
};

/// Simplifies a surface step by step. [0] is the surface itself, and each further LOD has clearly fewer triangles than
/// the one before, so a small mesh has fewer LODs. The result is never empty.
/// SurfaceSimplifier makes the LODs. Where it misses a step, because a character without a texture has many loose
/// pieces, meshoptimizer's clustering does.
std::vector<MeshLod> build_mesh_lods(const SkinnedSurfaceView& surface);

/// Picks the coarsest mesh LOD that has enough triangles for the pixels it covers, but none finer than `at_least`.
/// `triangles_by_lod` descends. `detail` scales the wanted number of triangles: 1 means one for about every 5 pixels.
int pick_mesh_lod(std::span<const std::uint32_t> triangles_by_lod, float pixels_tall, int at_least, float detail);

}  // namespace throng::render
