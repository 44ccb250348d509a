#include "engine/render/mesh_lod.h"

#include <algorithm>
#include <array>
#include <cassert>

#include <meshoptimizer.h>

namespace throng::render {
namespace {

struct Step {
  double share;     ///< of the full mesh's triangles
  float tolerance;  ///< of the mesh's extent: collapses stop here
};

constexpr std::array<Step, largest_mesh_lod_count - 1> steps = {{{0.30, 0.01F}, {0.10, 0.03F}, {0.03, 0.08F}}};

// A LOD that misses its target by more than this is worth trying with clustering.
constexpr double missed_by = 1.5;
// A LOD that saves less than this over the one before is not worth its draw call.
constexpr double worth_keeping = 0.8;

constexpr std::size_t position_bytes = 3 * sizeof(float);

struct Surface {
  std::span<const float> positions;
  std::span<const std::uint32_t> indices;
  std::size_t vertex_count() const { return positions.size() / 3; }
};

MeshLod collapse_edges(const Surface& surface, std::size_t target, float tolerance) {
  MeshLod lod;
  lod.indices.resize(surface.indices.size());
  lod.indices.resize(meshopt_simplify(lod.indices.data(), surface.indices.data(), surface.indices.size(),
                                      surface.positions.data(), surface.vertex_count(), position_bytes, target,
                                      tolerance, 0, &lod.error));
  return lod;
}

MeshLod cluster(const Surface& surface, std::size_t target, float tolerance) {
  MeshLod lod;
  lod.indices.resize(surface.indices.size());
  lod.indices.resize(meshopt_simplifySloppy(lod.indices.data(), surface.indices.data(), surface.indices.size(),
                                            surface.positions.data(), surface.vertex_count(), position_bytes, target,
                                            tolerance, &lod.error));
  return lod;
}

MeshLod simplify(const Surface& surface, const Step& step) {
  const auto target = static_cast<std::size_t>(static_cast<double>(surface.indices.size() / 3) * step.share) * 3;
  MeshLod lod = collapse_edges(surface, target, step.tolerance);
  if (static_cast<double>(lod.indices.size()) > static_cast<double>(target) * missed_by) {
    MeshLod clustered = cluster(surface, target, step.tolerance);
    if (!clustered.indices.empty() && clustered.indices.size() < lod.indices.size()) lod = std::move(clustered);
  }
  lod.error *= meshopt_simplifyScale(surface.positions.data(), surface.vertex_count(), position_bytes);
  return lod;
}

}  // namespace

std::vector<MeshLod> build_mesh_lods(std::span<const float> positions, std::span<const std::uint32_t> indices) {
  std::vector<MeshLod> lods;
  lods.push_back({{indices.begin(), indices.end()}, 0.0F});
  if (indices.empty()) return lods;
  for (const Step& step : steps) {
    MeshLod lod = simplify({positions, indices}, step);
    const auto most = static_cast<std::size_t>(static_cast<double>(lods.back().indices.size()) * worth_keeping);
    if (lod.indices.empty() || lod.indices.size() > most) continue;
    lods.push_back(std::move(lod));
  }
  return lods;
}

int pick_mesh_lod(std::span<const std::uint32_t> triangles_by_lod, float pixels_tall, int at_least, float detail) {
  assert(!triangles_by_lod.empty());
  // A standing figure covers about a quarter of the square of its height.
  constexpr float covered_share = 0.25F;
  constexpr float pixels_a_triangle = 12.0F;
  const float wanted = detail * pixels_tall * pixels_tall * covered_share / pixels_a_triangle;
  const int coarsest = static_cast<int>(triangles_by_lod.size()) - 1;
  int lod = coarsest;
  while (lod > at_least && static_cast<float>(triangles_by_lod[static_cast<std::size_t>(lod)]) < wanted) --lod;
  return std::clamp(lod, std::min(at_least, coarsest), coarsest);
}

}  // namespace throng::render
