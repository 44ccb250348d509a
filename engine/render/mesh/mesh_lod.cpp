#include "engine/render/mesh/mesh_lod.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <future>
#include <utility>

#include <meshoptimizer.h>

namespace throng::render {
namespace {

/// The steps of simplification, in shares of the triangles. Each is measured.
constexpr std::array steps{0.7, 0.5, 0.35, 0.25, 0.17, 0.12, 0.08, 0.05, 0.03};
/// The errors that the LODs are for, in shares of the surface's extent. At half a pixel, they serve characters that are
/// 125, 37 and 12 pixels tall.
constexpr std::array<double, largest_mesh_lod_count - 1> errors{1.0 / 250, 1.0 / 75, 1.0 / 25};
constexpr double farthest_merge = 0.08;  // in shares of the surface's extent

// A LOD that misses its target by more than this is worth trying with clustering.
constexpr double missed_by = 1.5;
// A LOD that saves less than this over the one before is not worth its draw call.
constexpr double worth_keeping = 0.8;
constexpr double worth_measuring = 0.97;  // over the candidate before

constexpr std::size_t position_bytes = 3 * sizeof(float);

double share_of(std::size_t count, double share) { return static_cast<double>(count) * share; }

/// Joins the vertices of each cell of space. It keeps no topology and few shapes, but always reaches the target.
std::vector<std::uint32_t> clustered(const SkinnedSurfaceView& surface, std::size_t triangles) {
  std::vector<std::uint32_t> indices(surface.indices.size());
  indices.resize(meshopt_simplifySloppy(indices.data(), surface.indices.data(), surface.indices.size(),
                                        surface.positions.data(), surface.positions.size() / 3, position_bytes,
                                        triangles * 3, static_cast<float>(farthest_merge), nullptr));
  return indices;
}

void simplify(const SkinnedSurfaceView& surface, double extent, std::vector<MeshLod>& candidates) {
  SurfaceSimplifier simplifier(surface);
  for (const double step : steps) {
    const auto target = static_cast<std::size_t>(share_of(surface.indices.size() / 3, step));
    simplifier.reduce_to(target, farthest_merge * extent);
    std::vector<std::uint32_t> indices = simplifier.indices();
    // Clusters would mix parts of a texture.
    const bool missed = static_cast<double>(simplifier.triangle_count()) > share_of(target, missed_by);
    if (surface.texture_coords.empty() && missed) {
      std::vector<std::uint32_t> clusters = clustered(surface, target);
      if (!clusters.empty() && clusters.size() < indices.size()) indices = std::move(clusters);
    }
    if (indices.empty() ||
        static_cast<double>(indices.size()) > share_of(candidates.back().indices.size(), worth_measuring)) {
      continue;
    }
    candidates.push_back({.indices = std::move(indices)});
  }
}

/// Adds a candidate that has clearly fewer triangles than the LOD before.
void keep(const MeshLod& candidate, std::vector<MeshLod>& lods) {
  const double most = share_of(lods.back().indices.size(), worth_keeping);
  if (static_cast<double>(candidate.indices.size()) <= most) lods.push_back(candidate);
}

}  // namespace

void measure_mesh_lods(std::span<MeshLod> lods, const MeshErrorMeter& meter) {
  std::vector<std::future<float>> measured;
  for (const MeshLod& lod : lods.subspan(1)) {
    measured.push_back(std::async([&meter, &lod] { return meter.error_of(lod.indices); }));
  }
  for (std::size_t i = 1; i < lods.size(); ++i) lods[i].error = std::max(lods[i - 1].error, measured[i - 1].get());
}

std::vector<MeshLod> build_mesh_lods(const SkinnedSurfaceView& surface, const MeshErrorMeter& meter) {
  std::vector<MeshLod> candidates;
  candidates.push_back({{surface.indices.begin(), surface.indices.end()}, 0.0F});
  if (surface.indices.empty()) return candidates;
  const double extent = static_cast<double>(
      meshopt_simplifyScale(surface.positions.data(), surface.positions.size() / 3, position_bytes));
  simplify(surface, extent, candidates);
  measure_mesh_lods(candidates, meter);
  std::vector<MeshLod> lods{candidates.front()};
  for (const double error : errors) {
    const auto coarsest = std::find_if(candidates.rbegin(), candidates.rend(), [&](const MeshLod& lod) {
      return static_cast<double>(lod.error) <= error * extent;
    });
    keep(*coarsest, lods);
  }
  // The coarsest of all serves characters that are a few pixels tall.
  if (lods.size() < largest_mesh_lod_count) keep(candidates.back(), lods);
  return lods;
}

int pick_mesh_lod(std::span<const float> error_by_lod, float limit) {
  assert(!error_by_lod.empty());
  std::size_t lod = error_by_lod.size() - 1;
  while (lod > 0 && error_by_lod[lod] > limit) --lod;
  return static_cast<int>(lod);
}

}  // namespace throng::render
