#include "engine/anim/run/fused/tile_lists.h"

namespace throng::anim {

void TileLists::reserve(std::size_t fetch_bytes) {
  const std::size_t blocks = fetch_bytes / entity_header_bytes;  // none is smaller
  for (std::vector<std::byte*>& list : origins) list.resize(blocks);
  shown.resize(blocks);
  tails.reserve(blocks);
}

std::size_t TileLists::bytes() const {
  std::size_t bytes = sizeof(TileLists) + tails.bytes() + shown.capacity() * sizeof(ShownClips);
  for (const std::vector<std::byte*>& list : origins) bytes += list.capacity() * sizeof(std::byte*);
  return bytes;
}

}  // namespace throng::anim
