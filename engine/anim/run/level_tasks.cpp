#include "engine/anim/run/level_tasks.h"

#include <algorithm>

#include "engine/anim/entity/ease_blender.h"

namespace throng::anim {

std::size_t EntityTasks::fetch_bytes(const UpdateContext& context, std::uint32_t largest_player,
                                     std::uint32_t largest_source) {
  const std::uint32_t blender = context.pools->layout(EntityPools::ease_blenders).total_size;
  return std::max(largest_player, blender + 2 * largest_source);
}

void EntityTasks::fetch(int task, int buffer, CopyEngine& engine) const {
  const EntityPools& pools = *context_->pools;
  const EntityUpdate& entity = update(task);
  std::byte* local = store_->fetch_buffer(buffer).data();
  engine.fetch(pools.block(entity.entity), local, pools.layout(entity.entity).total_size);
  if (!entity.from.valid()) return;
  local += pools.layout(entity.entity).total_size;
  engine.fetch(pools.block(entity.from), local, pools.layout(entity.from).source_bytes());
  local += pools.layout(entity.from).source_bytes();
  engine.fetch(pools.block(entity.to), local, pools.layout(entity.to).source_bytes());
}

void EntityTasks::write_back(int task, int buffer, CopyEngine& engine) const {
  const Handle entity = update(task).entity;
  engine.write_back(store_->fetch_buffer(buffer).data(), context_->pools->block(entity),
                    context_->pools->layout(entity).total_size);
}

void EntityTasks::compute(int task, int buffer, CopyEngine& engine) {
  ++entities_done_;
  const EntityUpdate& entity = update(task);
  std::byte* const block = store_->fetch_buffer(buffer).data();
  reinterpret_cast<AnimationStateHeader*>(block)->delta_time += entity.delta;
  if (entity.from.valid()) {
    compute_blender(entity, block, engine);
  } else {
    compute_player(entity, block, engine);
  }
}

void EntityTasks::compute_player(const EntityUpdate& entity, std::byte* block, CopyEngine& engine) const {
  auto& player = *reinterpret_cast<Player*>(block);
  const EntityLayout& layout = context_->pools->layout(entity.entity);
  const ClipStreams& clip = context_->clips[player.clip];
  advance_player(player, clip);
  const PlayerPose pose = begin_pose(player, clip, {block + layout.private_offset, layout.private_bytes()});
  float* out = transforms_of(player.state);
  for (int packet = 0; packet < context_->packets(entity.level); ++packet) {
    pose_packet(pose, *context_->kernels, context_->components, packet, out);
    out += packet_bytes(context_->components) / sizeof(float);
    engine.advance();
  }
}

void EntityTasks::compute_blender(const EntityUpdate& entity, std::byte* block, CopyEngine& engine) const {
  auto& blender = *reinterpret_cast<EaseBlender*>(block);
  std::byte* const from_block = block + context_->pools->layout(entity.entity).total_size;
  std::byte* const to_block = from_block + context_->pools->layout(entity.from).source_bytes();
  const float* from = transforms_of(*reinterpret_cast<const AnimationStateHeader*>(from_block));
  const float* to = transforms_of(*reinterpret_cast<const AnimationStateHeader*>(to_block));
  advance_blender(blender);
  float* out = transforms_of(blender.state);
  const std::size_t stride = packet_bytes(context_->components) / sizeof(float);
  for (int packet = 0; packet < context_->packets(entity.level); ++packet) {
    blend_packet(blender, context_->mask(blender.mask), *context_->kernels, packet, from, to, out);
    from += stride;
    to += stride;
    out += stride;
    engine.advance();
  }
}

PaletteTasks::PaletteTasks(const UpdateContext& context, std::span<const AgentWork> work, std::span<const Tile> tiles,
                           TaskQueue::Taker queue, const LocalStore& store, int width, PaletteMatrix* unseen)
    : context_(&context), work_(work), tiles_(tiles), queue_(queue), store_(&store), width_(width), unseen_(unseen) {
  ScratchCarver carver(store.scratch());
  scratch_ = ModelScratch::carve(carver, width, context.components, context.hierarchy->slot_count, false);
}

std::size_t PaletteTasks::fetch_bytes(const UpdateContext& context, int width) {
  return static_cast<std::size_t>(width) * packet_bytes(context.components);
}

std::size_t PaletteTasks::scratch_bytes(const UpdateContext& context, int width) {
  ScratchCarver carver({});
  ModelScratch::carve(carver, width, context.components, context.hierarchy->slot_count, false);
  return carver.used();
}

std::optional<PaletteTasks::Task> PaletteTasks::next() {
  if (last_ && last_->packet + 1 < context_->packets(agents(*last_).front().level)) {
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
  const std::size_t size = packet_bytes(context_->components);
  std::byte* local = store_->fetch_buffer(buffer).data();
  for (const AgentWork& work : agents(task)) {
    const std::byte* state = context_->pools->block(work.tree->root());
    const std::size_t offset = context_->pools->layout(work.tree->root()).transforms_offset;
    engine.fetch(state + offset + static_cast<std::size_t>(task.packet) * size, local, size);
    local += size;
  }
}

void PaletteTasks::compute(const Task& task, int buffer, CopyEngine& engine) {
  const std::span<const AgentWork> tile = agents(task);
  if (task.packet == 0) begin_palettes(scratch_, tile, unseen_);
  const auto* local = reinterpret_cast<const float*>(store_->fetch_buffer(buffer).data());
  model_palette_packet(*context_, scratch_, local, tile, width_, task.packet);
  engine.advance();
  if (task.packet + 1 < context_->packets(tile.front().level)) return;
  store_hashes(scratch_, tile);
  ++tiles_done_;
  agents_done_ += static_cast<std::uint32_t>(tile.size());
}

}  // namespace throng::anim
