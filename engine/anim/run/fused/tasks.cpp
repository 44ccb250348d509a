#include "engine/anim/run/fused/tasks.h"

#include <algorithm>
#include <bit>

#include "engine/anim/run/fused/advance.h"
#include "engine/anim/run/fused/pose_strip.h"
#include "engine/base/compiler.h"

namespace throng::anim {
namespace {

/// A hint: they lie scattered, and are read once an update.
void prefetch_entities(std::span<const AgentWork> soon) {
  for (const AgentWork& work : soon) prefetch(work.entities);
}

/// A hint: a long list has left the near caches, and is read too slowly to be seen coming.
void prefetch_work(std::span<const AgentWork> later) {
  const std::span<const std::byte> bytes = std::as_bytes(later);
  for (std::size_t line = 0; line < bytes.size(); line += block_alignment) prefetch(&bytes[line]);
}

int lanes_for(std::size_t characters) { return static_cast<int>(std::bit_ceil(characters)); }

}  // namespace

/// Returns as many agents as the task has, so many tasks behind its own.
std::span<const AgentWork> FusedTasks::agents_behind(int task, std::size_t tasks) const {
  const std::size_t count = tile(task).count;
  const std::size_t first = std::min(tile(task).first + tasks * count, work_.size());
  return work_.subspan(first, std::min(count, work_.size() - first));
}

/// Without its shared sources.
TileInStore FusedTasks::in_store(int task, int buffer) const {
  return {.context = &context(task),
          .work = agents(task),
          .runs = cut_.runs_of(tile(task)),
          .blocks = store_->fetch_buffer(buffer).data()};
}

void FusedTasks::fetch(int task, int buffer, CopyEngine& engine) {
  prefetch_work(agents_behind(task, 2));
  prefetch_entities(agents_behind(task, 1));
  const TileInStore fetched = in_store(task, buffer);
  copies_.fetch(fetched, buffer, engine);
  if (tile(task).needs.shared > 0) copies_.fetch_shared(fetched, SharedSources(fetched.runs), engine);
}

int FusedTasks::copy_points(int task) const {
  const int packets = context(task).packets(agents(task).front().level);
  return static_cast<int>(tile(task).strips()) * (packets + std::min<int>(tile(task).needs.held_packets, packets));
}

/// The scratch is nearly always divided as for the tile before.
void FusedTasks::divide_scratch(const Divided& wanted) {
  if (divided_ == wanted) return;
  divided_ = wanted;
  ScratchCarver carver(store_->scratch());
  scratch_ = FusedScratch::carve(carver, *wanted.context, wanted.needs, wanted.width, wanted.characters);
}

void FusedTasks::compute(int task, int buffer, CopyEngine& engine) {
  const Tile& cut = tile(task);
  TileInStore computed = in_store(task, buffer);
  if (cut.needs.shared > 0) {
    shared_ = SharedSources(computed.runs);
    computed.shared = &shared_;
    computed.shared_blocks = computed.blocks + computed.own_bytes();
  }
  divide_scratch({computed.context, cut.needs, lanes_for(std::min(cut.count, cut.width)), cut.count});
  StepCursor first_step{.block = computed.blocks, .prepared = scratch_.prepared.data()};
  advance_entities(computed, first_step, *lists_);
  copies_.write_back_final(computed, buffer, engine);
  const int packets = computed.context->packets(computed.work.front().level);
  for (std::size_t first = 0; first < cut.count; first += cut.width) {
    const std::size_t count = std::min<std::size_t>(cut.width, cut.count - first);
    const Strip strip{.tile = &computed,
                      .scratch = &scratch_,
                      .first = first,
                      .work = computed.work.subspan(first, count),
                      .width = lanes_for(count),
                      .packets = packets,
                      .held_packets = std::min<int>(cut.needs.held_packets, packets)};
    pose(strip, first_step, engine);
  }
  ++tiles_done_;
  agents_done_ += cut.count;
}

void FusedTasks::pose(const Strip& strip, StepCursor& first, CopyEngine& engine) {
  poses_.find(strip, *lists_, first);
  const bool held = divided_.needs.held;
  // Lanes beyond the last character compute on numbers, not on noise.
  if (strip.work.size() < static_cast<std::size_t>(strip.width)) {
    std::ranges::fill(held ? scratch_.held : scratch_.model.local, 0.0F);
  }
  StripPalettes palettes(strip.context(), scratch_.model, strip.work, strip.width, stores_);
  if (held) pose_held(strip, poses_, palettes, engine);
  pose_streaming(strip, poses_, palettes, engine);
  palettes.store_hashes();
}

void FusedTasks::write_back(int task, int buffer, CopyEngine& engine) const {
  copies_.write_back(in_store(task, buffer), buffer, engine);
}

}  // namespace throng::anim
