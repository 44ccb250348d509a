#include "engine/render/mesh/surface_pieces.h"

#include <algorithm>

namespace throng::render {
namespace {

bool is_silhouette(const SurfacePiece& piece) { return piece.first_lod > 0; }

std::size_t lods_with(const SurfaceParts& parts, bool has_silhouettes) {
  std::size_t count = parts.runs_by_lod.size();
  for (const SurfacePiece& piece : parts.pieces) {
    const std::size_t levels = piece.runs_by_level.size();
    if (is_silhouette(piece)) {
      count = std::max(count, piece.first_lod + levels);
    } else {
      count = std::max(count, has_silhouettes ? std::min(levels, first_silhouette_lod) : levels);
    }
  }
  return std::min(count, largest_mesh_lod_count);
}

void raise(MeshError& error, const MeshError& other) {
  error = {std::max(error.surface, other.surface), std::max(error.face, other.face)};
}

}  // namespace

void take_errors_of_pieces(SurfaceParts& parts) {
  if (parts.pieces.empty()) return;
  const bool has_silhouettes = std::ranges::any_of(parts.pieces, is_silhouette);
  const std::size_t lods = lods_with(parts, has_silhouettes);
  parts.runs_by_lod.resize(lods, std::vector(parts.runs_by_lod.back()));
  parts.triangles_by_lod.resize(lods, parts.triangles_by_lod.back());
  parts.error_by_lod.resize(lods, parts.error_by_lod.back());
  for (std::size_t lod = 1; lod < lods; ++lod) {
    MeshError& error = parts.error_by_lod[lod];
    raise(error, parts.error_by_lod[lod - 1]);
    const bool far = has_silhouettes && lod >= first_silhouette_lod;
    for (const SurfacePiece& piece : parts.pieces) {
      if (is_silhouette(piece) == far) raise(error, piece.error_by_level[piece.level_at(lod)]);
    }
  }
}

}  // namespace throng::render
