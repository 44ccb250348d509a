#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "throng/render/crowd_mesh_data.h"

#include "engine/render/mesh/mesh_error.h"
#include "engine/render/mesh/surface_simplifier.h"

namespace throng::render {

/// One mesh LOD: triangles over the original vertices, so that weights stay valid.
struct MeshLod {
  std::vector<std::uint32_t> indices;
  MeshError error = {};
};

/// Simplifies a surface step by step, measures each step, and keeps the steps with which a crowd of all sizes is
/// drawn at the least cost. [0] is the surface itself. Each further LOD has clearly fewer triangles than the one
/// before, so a surface that cannot be simplified has fewer LODs. The result is never empty. SurfaceSimplifier makes
/// the steps. Where it misses one, because a character without a texture has many loose pieces, meshoptimizer's
/// clustering does. A step that is off by more than the meter measures is left out. `meter` measures on `surface`.
std::vector<MeshLod> build_mesh_lods(const SkinnedSurfaceView& surface, const MeshErrorMeter& meter);

/// Measures all LODs but the first, which is the surface itself. No error is smaller than the one before.
void measure_mesh_lods(std::span<MeshLod> lods, const MeshErrorMeter& meter);

}  // namespace throng::render
