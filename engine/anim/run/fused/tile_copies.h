#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/anim/run/fused/tile_in_store.h"
#include "engine/anim/run/fused/tile_lists.h"
#include "engine/anim/run/store/copy_engine.h"
#include "engine/anim/run/store/schedule.h"

namespace throng::anim {

/// Copies the blocks of a tile into a fetch buffer and back. It finds the address of a block once, when it fetches it,
/// and writes the block back there. A shared source is fetched once a tile and never written back.
class TileCopies {
 public:
  TileCopies(TileLists& lists, BlockChanges changes) : lists_(&lists), changes_(changes) {}

  /// Queues the blocks that the entities of the tile read.
  void fetch(const TileInStore& tile, int buffer, CopyEngine& engine);
  /// Queues the sources that no agent of the tile owns; they lie behind all others.
  static void fetch_shared(const TileInStore& tile, const SharedSources& shared, CopyEngine& engine);
  /// Writes back at once the blocks that posing does not change.
  void write_back_final(const TileInStore& tile, int buffer, CopyEngine& engine);
  /// Queues the write-back of the blocks that posing changes.
  void write_back(const TileInStore& tile, int buffer, CopyEngine& engine) const;

 private:
  template <typename Visit>
  void for_each_fetched_row(const TileInStore& tile, int buffer, Visit&& visit) const;

  TileLists* lists_;
  BlockChanges changes_;
  std::array<std::size_t, 2> list_of_{};  // [fetch buffer] the list of origins of its tile
  std::size_t next_list_ = 0;
  std::array<bool, 2> rows_left_{};  // [fetch buffer] some rows are written back when its tile is done
};

}  // namespace throng::anim
