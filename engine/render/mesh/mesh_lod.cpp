#include "engine/render/mesh/mesh_lod.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include <meshoptimizer.h>

namespace throng::render {
namespace {

struct Step {
  double share;      ///< of the full mesh's triangles
  double tolerance;  ///< merging stops at this share of the mesh's extent
};

constexpr std::array<Step, largest_mesh_lod_count - 1> steps = {{{0.30, 0.01}, {0.10, 0.03}, {0.03, 0.08}}};

// A LOD that misses its target by more than this is worth trying with clustering.
constexpr double missed_by = 1.5;
// A LOD that saves less than this over the one before is not worth its draw call.
constexpr double worth_keeping = 0.8;

constexpr std::size_t position_bytes = 3 * sizeof(float);

double share_of(std::size_t count, double share) { return static_cast<double>(count) * share; }

/// Joins the vertices of each cell of space. It keeps no topology and few shapes, but always reaches the target.
MeshLod cluster(const SkinnedSurfaceView& surface, std::size_t triangles, const Step& step) {
  const std::size_t vertices = surface.positions.size() / 3;
  MeshLod lod;
  lod.indices.resize(surface.indices.size());
  lod.indices.resize(meshopt_simplifySloppy(lod.indices.data(), surface.indices.data(), surface.indices.size(),
                                            surface.positions.data(), vertices, position_bytes, triangles * 3,
                                            static_cast<float>(step.tolerance), &lod.error));
  lod.error *= meshopt_simplifyScale(surface.positions.data(), vertices, position_bytes);
  return lod;
}

}  // namespace

std::vector<MeshLod> build_mesh_lods(const SkinnedSurfaceView& surface) {
  std::vector<MeshLod> lods;
  lods.push_back({{surface.indices.begin(), surface.indices.end()}, 0.0F});
  if (surface.indices.empty()) return lods;
  const double extent = static_cast<double>(
      meshopt_simplifyScale(surface.positions.data(), surface.positions.size() / 3, position_bytes));
  SurfaceSimplifier simplifier(surface);
  for (const Step& step : steps) {
    const auto target = static_cast<std::size_t>(share_of(surface.indices.size() / 3, step.share));
    simplifier.reduce_to(target, step.tolerance * extent);
    MeshLod lod{simplifier.indices(), static_cast<float>(simplifier.error())};
    // Clusters would mix parts of a texture.
    if (surface.texture_coords.empty() &&
        static_cast<double>(simplifier.triangle_count()) > share_of(target, missed_by)) {
      MeshLod clustered = cluster(surface, target, step);
      if (!clustered.indices.empty() && clustered.indices.size() < lod.indices.size()) lod = std::move(clustered);
    }
    const double most = share_of(lods.back().indices.size(), worth_keeping);
    if (!lod.indices.empty() && static_cast<double>(lod.indices.size()) <= most) lods.push_back(std::move(lod));
  }
  return lods;
}

int pick_mesh_lod(std::span<const std::uint32_t> triangles_by_lod, float pixels_tall, int at_least, float detail) {
  assert(!triangles_by_lod.empty());
  // A standing figure covers about a quarter of the square of its height.
  constexpr float covered_share = 0.25F;
  constexpr float pixels_a_triangle = 5.0F;
  const float wanted = detail * pixels_tall * pixels_tall * covered_share / pixels_a_triangle;
  const int coarsest = static_cast<int>(triangles_by_lod.size()) - 1;
  int lod = coarsest;
  while (lod > at_least && static_cast<float>(triangles_by_lod[static_cast<std::size_t>(lod)]) < wanted) --lod;
  return std::clamp(lod, std::min(at_least, coarsest), coarsest);
}

}  // namespace throng::render
