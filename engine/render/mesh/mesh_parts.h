#pragma once

#include <algorithm>
#include <span>

#include "throng/render/crowd_mesh_data.h"

namespace throng::render {

/// Returns the baked LODs of a character that are used: the first few.
inline std::span<const BakedLodData> used_baked_lods(const CrowdMeshData& data) {
  return std::span(data.baked_lods).first(std::min(data.baked_lods.size(), largest_mesh_lod_count - 1));
}

/// Says whether a level of a piece is the very mesh of the level before it, and needs no vertices of its own.
inline bool repeats_the_level_before(const MeshPieceData& piece, std::size_t level) {
  if (level == 0) return false;
  return std::ranges::equal(piece.levels[level - 1].parts, piece.levels[level].parts,
                            [](const MeshPartData& before, const MeshPartData& part) {
                              return before.positions.data() == part.positions.data() &&
                                     before.indices.data() == part.indices.data();
                            });
}

/// Calls visit(part) for all parts in the order of their vertices in a surface.
void for_each_part(const CrowdMeshData& data, const auto& visit) {
  std::ranges::for_each(data.parts, visit);
  for (const BakedLodData& baked : used_baked_lods(data)) std::ranges::for_each(baked.parts, visit);
  for (const MeshPieceData& piece : data.pieces) {
    for (std::size_t level = 0; level < piece.levels.size(); ++level) {
      if (!repeats_the_level_before(piece, level)) std::ranges::for_each(piece.levels[level].parts, visit);
    }
  }
}

}  // namespace throng::render
