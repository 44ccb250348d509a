#include "app/show/worn_pieces.h"

#include <algorithm>
#include <span>

#include "app/show/stage/stage.h"
#include "engine/crowd/sorted_draws.h"

namespace throng::app {
namespace {

/// Counts, for each piece, how many agents of a character are drawn with it at a mesh LOD.
std::vector<std::uint32_t> wearers(const Stage& stage, std::size_t character, std::size_t pieces, std::uint32_t lod) {
  const std::vector<render::Outfit>& outfits = stage.crowd().looks().outfits;
  std::vector<std::uint32_t> counts(pieces, 0);
  for (std::size_t agent = 0; agent < outfits.size(); ++agent) {
    if (stage.crowd().characters()[agent] != character) continue;
    for_each_worn(outfits[agent], lod, [&](std::uint32_t piece) { ++counts[piece]; });
  }
  return counts;
}

/// Returns a mesh LOD that is off at least as much as the one before it.
MeshLevel level_of(const render::CrowdMesh& mesh, std::span<const std::uint32_t> wearers, std::uint32_t agents,
                   std::span<const MeshLevel> finer) {
  const std::size_t lod = finer.size();
  MeshLevel level;
  if (lod > 0) level.error = finer.back().error;
  std::uint64_t triangles = 0;
  for (std::size_t piece = 0; piece < wearers.size(); ++piece) {
    if (wearers[piece] == 0) continue;
    triangles += std::uint64_t{mesh.triangles(piece, lod)} * wearers[piece];
    const render::MeshError& error = mesh.error(piece, lod);
    level.error = {std::max(level.error.surface, error.surface), std::max(level.error.face, error.face)};
  }
  level.triangles = static_cast<std::uint32_t>(triangles / agents);
  return level;
}

}  // namespace

std::vector<MeshLevel> worn_levels(const Stage& stage, std::size_t character, const render::CrowdMesh& mesh) {
  const auto agents = static_cast<std::uint32_t>(std::ranges::count(stage.crowd().characters(), character));
  if (stage.crowd().looks().outfits.empty() || agents == 0) {
    return mesh_levels(mesh.triangles_by_lod(), mesh.error_by_lod());
  }
  std::vector<MeshLevel> levels;
  std::size_t lods = 1;
  for (std::uint32_t lod = 0; lod < render::largest_mesh_lod_count; ++lod) {
    const std::vector<std::uint32_t> counts = wearers(stage, character, mesh.piece_count(), lod);
    for (std::size_t piece = 0; piece < counts.size(); ++piece) {
      if (counts[piece] > 0) lods = std::max(lods, mesh.lod_count(piece));
    }
    levels.push_back(level_of(mesh, counts, agents, levels));
  }
  levels.resize(lods);
  return levels;
}

}  // namespace throng::app
