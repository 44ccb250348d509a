#include "engine/anim/run/fused/tile_copies.h"

namespace throng::anim {
namespace {

/// Calls visit(step index, layout, run, row without its blocks) for each step whose blocks the characters of a tile
/// own. It goes run by run, since the blocks of one step come from one pool.
template <typename Visit>
void for_each_row_of_blocks(const TileInStore& tile, Visit&& visit) {
  const EntityPools& pools = *tile.context->pools;
  std::byte* first = tile.blocks;
  for (const AgentRun& run : tile.runs) {
    const std::size_t stride = run.program->needs.fetch_bytes;
    std::byte* block = first;
    for (std::size_t i = 0; i < run.program->steps.size(); ++i) {
      const PoseStep& step = run.program->steps[i];
      if (step.is_shared()) continue;
      const EntityLayout& layout = step.layout(pools);
      visit(i, layout, run, BlockRow{.local = block, .stride = stride, .size = layout.total_size});
      block += layout.total_size;
    }
    first += stride * run.count;
  }
}

}  // namespace

void TileCopies::fetch(const TileInStore& tile, int buffer, CopyEngine& engine) {
  const EntityPools& pools = *tile.context->pools;
  list_of_[static_cast<std::size_t>(buffer)] = next_list_;
  std::span<std::byte*> origins = lists_->origins[next_list_];
  next_list_ = (next_list_ + 1) % lists_->origins.size();
  for_each_row_of_blocks(tile, [&](std::size_t step, const EntityLayout& layout, const AgentRun& run, BlockRow row) {
    const Pool& pool = pools.pool(EntityPools::Kind{run.program->steps[step].kind});
    const AgentWork* const work = &tile.work[run.first];
    for (std::size_t i = 0; i < run.count; ++i) origins[i] = pool.block(work[i].entities[step]);
    row.blocks = origins.first(run.count);
    origins = origins.subspan(run.count);
    engine.fetch(row, layout.unread_bytes());
  });
}

void TileCopies::fetch_shared(const TileInStore& tile, const SharedSources& shared, CopyEngine& engine) {
  const EntityPools& pools = *tile.context->pools;
  std::byte* local = tile.blocks + tile.own_bytes();
  for (const Handle source : shared.all()) {
    const std::size_t size = pools.layout(source).source_bytes();
    engine.fetch(pools.block(source), local, size);
    local += size;
  }
}

/// Calls visit(layout, row) for each row that was fetched.
template <typename Visit>
void TileCopies::for_each_fetched_row(const TileInStore& tile, int buffer, Visit&& visit) const {
  std::span<std::byte* const> origins = lists_->origins[list_of_[static_cast<std::size_t>(buffer)]];
  for_each_row_of_blocks(tile, [&](std::size_t, const EntityLayout& layout, const AgentRun& run, BlockRow row) {
    row.blocks = origins.first(run.count);
    origins = origins.subspan(run.count);
    visit(layout, row);
  });
}

void TileCopies::write_back_final(const TileInStore& tile, int buffer, CopyEngine& engine) {
  bool left = false;
  if (changes_ == BlockChanges::written_back) {
    for_each_fetched_row(tile, buffer, [&](const EntityLayout& layout, const BlockRow& row) {
      if (layout.final_once_advanced()) {
        engine.write_back_now(row, identity_bytes);
      } else {
        left = true;
      }
    });
  }
  rows_left_[static_cast<std::size_t>(buffer)] = left;
}

void TileCopies::write_back(const TileInStore& tile, int buffer, CopyEngine& engine) const {
  if (!rows_left_[static_cast<std::size_t>(buffer)]) return;
  for_each_fetched_row(tile, buffer, [&](const EntityLayout& layout, const BlockRow& row) {
    if (!layout.final_once_advanced()) engine.write_back(row, identity_bytes);
  });
}

}  // namespace throng::anim
