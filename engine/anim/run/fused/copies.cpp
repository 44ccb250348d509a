// What a tile brings into the local store, and what goes back to main memory.

#include <algorithm>

#include "engine/anim/run/fused/characters.h"

namespace throng::anim {
namespace {

/// A hint: they lie scattered, and are read once an update.
void prefetch_entities(std::span<const AgentWork> soon) {
  for (const AgentWork& work : soon) __builtin_prefetch(work.entities);
}

/// A hint: a long list has left the near caches, and is read too slowly to be seen coming.
void prefetch_work(std::span<const AgentWork> later) {
  const std::span<const std::byte> bytes = std::as_bytes(later);
  for (std::size_t line = 0; line < bytes.size(); line += block_alignment) __builtin_prefetch(&bytes[line]);
}

/// Calls visit(step index, layout, run, row without its blocks) for each step whose blocks the characters of a tile
/// own; run by run, since blocks of one step come from one pool.
template <typename Visit>
void for_each_row_of_blocks(const EntityPools& pools, std::span<const AgentWork> tile, const PoseProgram* program,
                            std::byte* local, Visit&& visit) {
  for_each_alike(tile, program, [&](const AlikeRun& run) {
    const std::size_t stride = run.program->needs.fetch_bytes;
    std::byte* block = local;
    for (std::size_t i = 0; i < run.program->steps.size(); ++i) {
      const PoseStep& step = run.program->steps[i];
      if (step.is_shared()) continue;
      const EntityLayout& layout = step.layout(pools);
      visit(i, layout, run, BlockRow{.local = block, .stride = stride, .size = layout.total_size});
      block += layout.total_size;
    }
    local += stride * run.size();
  });
}

}  // namespace

std::span<const AgentWork> FusedTasks::agents_behind(int task, std::size_t tasks) const {
  const std::size_t count = tile_of(task).count;
  const std::size_t first = std::min(tile_of(task).first + tasks * count, work_.size());
  return work_.subspan(first, std::min(count, work_.size() - first));
}

void FusedTasks::fetch(int task, int buffer, CopyEngine& engine) {
  prefetch_work(agents_behind(task, 2));
  prefetch_entities(agents_behind(task, 1));
  const EntityPools& pools = *context(task).pools;
  std::byte* local = store_->fetch_buffer(buffer).data();
  const std::span<const AgentWork> tile = agents(task);
  homes_[static_cast<std::size_t>(buffer)] = next_homes_;
  std::span<std::byte*> homes = notes_->homes[next_homes_];
  next_homes_ = (next_homes_ + 1) % notes_->homes.size();
  for_each_row_of_blocks(pools, tile, tile_of(task).program, local,
                         [&](std::size_t step, const EntityLayout& layout, const AlikeRun& run, BlockRow row) {
                           const Pool& pool = pools.pool(EntityPools::Kind{run.program->steps[step].kind});
                           for (std::size_t i = 0; i < run.size(); ++i)
                             homes[i] = pool.block(tile[run.first + i].entities[step]);
                           row.blocks = homes.first(run.size());
                           homes = homes.subspan(run.size());
                           engine.fetch(row, layout.unread_bytes());
                         });
  if (tile_of(task).needs.shared == 0) return;
  local += own_bytes(tile);
  const SharedSources shared(tile);
  for (const Handle source : shared.all()) {
    const std::size_t size = pools.layout(source).source_bytes();
    engine.fetch(pools.block(source), local, size);
    local += size;
  }
}

/// Calls visit(layout, row) for each row of blocks, which knows where they belong.
template <typename Visit>
void FusedTasks::for_each_row_to_go_home(int task, int buffer, Visit&& visit) const {
  std::span<std::byte* const> homes = notes_->homes[homes_[static_cast<std::size_t>(buffer)]];
  for_each_row_of_blocks(*context(task).pools, agents(task), tile_of(task).program, store_->fetch_buffer(buffer).data(),
                         [&](std::size_t, const EntityLayout& layout, const AlikeRun& run, BlockRow row) {
                           row.blocks = homes.first(run.size());
                           homes = homes.subspan(run.size());
                           visit(layout, row);
                         });
}

void FusedTasks::write_back_final_rows(int task, int buffer, CopyEngine& engine) {
  bool left = false;
  if (changes_ == BlockChanges::written_back) {
    for_each_row_to_go_home(task, buffer, [&](const EntityLayout& layout, const BlockRow& row) {
      if (layout.final_once_advanced()) {
        engine.write_back_now(row, identity_bytes);
      } else {
        left = true;
      }
    });
  }
  rows_left_[static_cast<std::size_t>(buffer)] = left;
}

void FusedTasks::write_back(int task, int buffer, CopyEngine& engine) const {
  if (!rows_left_[static_cast<std::size_t>(buffer)]) return;
  for_each_row_to_go_home(task, buffer, [&](const EntityLayout& layout, const BlockRow& row) {
    if (!layout.final_once_advanced()) engine.write_back(row, identity_bytes);
  });
}

}  // namespace throng::anim
