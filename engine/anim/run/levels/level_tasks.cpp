#include "engine/anim/run/levels/level_tasks.h"

#include <array>
#include <bit>

#include "engine/anim/entity/entity_run.h"
#include "engine/anim/run/store/pose_entity.h"

namespace throng::anim {

void EntityTasks::fetch(int task, int buffer, CopyEngine& engine) const {
  const EntityPools& pools = *context(task).pools;
  const EntityUpdate& entity = update(task);
  std::byte* local = store_->fetch_buffer(buffer).data();
  const auto fetch_block = [&](Handle block, std::uint32_t size) {
    engine.fetch(pools.block(block), local, size);
    local += size;
  };
  fetch_block(entity.entity(), pools.layout(entity.entity()).total_size);
  for (std::size_t i = 0; i < entity.source_count(); ++i) {
    fetch_block(entity.source(i), pools.layout(entity.source(i)).source_bytes());
  }
}

void EntityTasks::write_back(int task, int buffer, CopyEngine& engine) const {
  const EntityPools& pools = *context(task).pools;
  const Handle entity = update(task).entity();
  engine.write_back(store_->fetch_buffer(buffer).data(), pools.block(entity), pools.layout(entity).total_size);
}

void EntityTasks::compute(int task, int buffer, CopyEngine& engine) {
  ++entities_done_;
  const UpdateContext& about = context(task);
  const EntityUpdate& work = update(task);
  const auto view = [&](AnimationStateHeader& state) {
    return PoseView{transforms_of(state), about.packet_floats(), about.assets.components,
                    about.bones(work.agent->level)};
  };
  const EntityInStore entity{.block = store_->fetch_buffer(buffer).data(),
                             .prepared = store_->scratch().data(),
                             .layout = &about.pools->layout(work.entity()),
                             .assets = &about.assets};
  std::array<SourceRow, max_sources> sources;
  std::array<PoseView, max_sources> poses;
  std::byte* source = entity.block + entity.layout->total_size;
  for (std::size_t i = 0; i < work.source_count(); ++i) {
    auto& state = *reinterpret_cast<AnimationStateHeader*>(source);
    sources[i] = {.first = source, .stride = 0, .shown = nullptr};
    poses[i] = view(state);
    source += about.pools->layout(work.source(i)).source_bytes();
  }
  auto& state = entity.as<AnimationStateHeader>();
  state.delta_time += work.agent->delta;
  entity.layout->kind->advance({.first = entity, .sources = std::span(sources).first(work.source_count())});
  pose_entity(entity, {poses.data(), work.source_count()}, view(state), about.packets(work.agent->level), &engine);
}

std::size_t PaletteTasks::fetch_bytes(const UpdateContext& context, int width) {
  return static_cast<std::size_t>(width) * packet_bytes(context.assets.components);
}

std::size_t PaletteTasks::scratch_bytes(const UpdateContext& context, int width) {
  ScratchCarver carver({});
  ModelScratch::carve(carver, width, context, false);
  return carver.used();
}

std::optional<PaletteTasks::Task> PaletteTasks::next() {
  if (last_ && last_->packet + 1 < context(*last_).packets(agents(*last_).front().level)) {
    ++last_->packet;
  } else if (const auto tile = queue_.take()) {
    last_ = Task{.tile = *tile, .packet = 0};
  } else {
    last_.reset();
  }
  return last_;
}

std::span<const AgentWork> PaletteTasks::agents(const Task& task) const {
  const Tile& tile = tiles_[static_cast<std::size_t>(task.tile)];
  return work_.subspan(tile.first, tile.count);
}

void PaletteTasks::fetch(const Task& task, int buffer, CopyEngine& engine) const {
  const EntityPools& pools = *context(task).pools;
  const std::size_t size = packet_bytes(context(task).assets.components);
  std::byte* local = store_->fetch_buffer(buffer).data();
  for (const AgentWork& work : agents(task)) {
    const Handle root = work.entities[work.program->steps.size() - 1];
    const std::size_t offset = pools.layout(root).transforms_offset + static_cast<std::size_t>(task.packet) * size;
    engine.fetch(pools.block(root) + offset, local, size);
    local += size;
  }
}

void PaletteTasks::begin_tile(const UpdateContext& context, std::span<const AgentWork> tile) {
  ScratchCarver carver(store_->scratch());
  const auto width = static_cast<int>(std::bit_ceil(tile.size()));
  const ModelScratch scratch = ModelScratch::carve(carver, width, context, false);
  palettes_ = StripPalettes(context, scratch, tile, width, stores_);
}

void PaletteTasks::compute(const Task& task, int buffer, CopyEngine& engine) {
  const std::span<const AgentWork> tile = agents(task);
  if (task.packet == 0) begin_tile(context(task), tile);
  auto* local = reinterpret_cast<float*>(store_->fetch_buffer(buffer).data());
  palettes_.write({.packet = task.packet, .local = local});
  engine.advance();
  if (task.packet + 1 < context(task).packets(tile.front().level)) return;
  palettes_.store_hashes();
  ++tiles_done_;
  agents_done_ += static_cast<std::uint32_t>(tile.size());
}

}  // namespace throng::anim
