#pragma once

#include <cstddef>
#include <cstdint>

namespace throng::render {

/// The first mesh LOD at which silhouettes take the place of the pieces that agents wear.
inline constexpr std::size_t first_silhouette_lod = 4;

/// A run of CrowdFrame::drawn whose instances share a palette page and a character, and are drawn with the same piece
/// of its mesh at the same mesh LOD.
struct CrowdBatch {
  std::uint32_t page = 0;
  std::uint8_t character = 0;  ///< its index in the order of loading
  std::uint8_t mesh_lod = 0;   ///< 0 is the full mesh
  std::uint16_t piece = 0;     ///< of the character's mesh; 0 is all of it
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  /// The piece, a silhouette, is not seen. It casts the shadows of its instances where a shadow map is too coarse to
  /// tell it from their pieces. If a run has such batches, all its agents with pieces are in one.
  bool stands_in = false;
};

}  // namespace throng::render
