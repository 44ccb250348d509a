#include "engine/render/mesh/mesh_lod.h"

#include <algorithm>
#include <array>
#include <bit>
#include <future>
#include <utility>

#include <meshoptimizer.h>

namespace throng::render {
namespace {

/// The steps of simplification, in shares of the triangles. Each is measured. Agents that are drawn with
/// the coarse steps are small and show no face, but a head, which is held about as firmly as its size asks for.
constexpr std::array fine_steps{0.65, 0.45, 0.3};
constexpr std::array coarse_steps{0.2, 0.12, 0.07, 0.04, 0.025, 0.015, 0.009};
constexpr double firmness_from_afar = 3.0;
// LODs are chosen for characters of these heights on screen, in pixels, and for this error. On open ground four times
// as many are half as tall.
constexpr double shortest = 4.0, tallest = 512.0, usual_error = 0.5;
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

void simplify(const SkinnedSurfaceView& surface, std::span<const double> steps, double extent,
              std::vector<MeshLod>& candidates) {
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

/// Returns the height on screen, in pixels, up to which a LOD of a surface of that extent serves.
double served_height(const MeshLod& lod, double extent) {
  const double error = std::max(static_cast<double>(lod.error.surface), extent * usual_error / tallest);
  return std::clamp(extent * usual_error / error, shortest, tallest);
}

bool each_is_worth_keeping(std::span<const MeshLod* const> lods) {
  return std::ranges::adjacent_find(lods, [](const MeshLod* finer, const MeshLod* coarser) {
           return static_cast<double>(coarser->indices.size()) > share_of(finer->indices.size(), worth_keeping);
         }) == lods.end();
}

/// Returns the mean number of indices that a character is drawn with, in a unit of its own.
double mean_cost(std::span<const MeshLod* const> lods, double extent) {
  double cost = 0.0, above = tallest;
  for (std::size_t i = 0; i < lods.size(); ++i) {
    const double below = i + 1 < lods.size() ? served_height(*lods[i + 1], extent) : shortest;
    cost += static_cast<double>(lods[i]->indices.size()) * (1.0 / (below * below) - 1.0 / (above * above));
    above = below;
  }
  return cost;
}

/// Returns the candidates with which a crowd is drawn at the least cost. The first is always among them.
std::vector<MeshLod> cheapest(std::span<const MeshLod> candidates, double extent) {
  std::vector<const MeshLod*> best{candidates.data()}, some;
  const std::uint32_t subsets = 1U << (candidates.size() - 1);
  for (std::uint32_t subset = 1; subset < subsets; ++subset) {
    if (static_cast<std::size_t>(std::popcount(subset)) >= largest_mesh_lod_count) continue;
    some.assign(1, candidates.data());
    for (std::size_t i = 1; i < candidates.size(); ++i) {
      if ((subset >> (i - 1) & 1U) != 0) some.push_back(&candidates[i]);
    }
    if (each_is_worth_keeping(some) && mean_cost(some, extent) < mean_cost(best, extent)) best = some;
  }
  std::vector<MeshLod> lods;
  lods.reserve(best.size());
  for (const MeshLod* lod : best) lods.push_back(*lod);
  return lods;
}

}  // namespace

void measure_mesh_lods(std::span<MeshLod> lods, const MeshErrorMeter& meter) {
  std::vector<std::future<MeshError>> measured;
  for (const MeshLod& lod : lods.subspan(1)) {
    measured.push_back(std::async([&meter, &lod] { return meter.error_of(lod.indices); }));
  }
  for (std::size_t i = 1; i < lods.size(); ++i) {
    const MeshError error = measured[i - 1].get(), &finer = lods[i - 1].error;
    lods[i].error = {std::max(finer.surface, error.surface), std::max(finer.face, error.face)};
  }
}

std::vector<MeshLod> build_mesh_lods(const SkinnedSurfaceView& surface, const MeshErrorMeter& meter) {
  std::vector<MeshLod> candidates;
  candidates.push_back({.indices = {surface.indices.begin(), surface.indices.end()}});
  if (surface.indices.empty()) return candidates;
  const auto extent = static_cast<double>(
      meshopt_simplifyScale(surface.positions.data(), surface.positions.size() / 3, position_bytes));
  simplify(surface, fine_steps, extent, candidates);
  SkinnedSurfaceView from_afar = surface;
  from_afar.face_firmness = firmness_from_afar;
  simplify(from_afar, coarse_steps, extent, candidates);
  measure_mesh_lods(candidates, meter);
  std::erase_if(candidates, [&](const MeshLod& lod) { return lod.error.surface >= meter.largest_error(); });
  return cheapest(candidates, static_cast<double>(meter.extent()));
}

}  // namespace throng::render
