#include "engine/anim/run/fused_tasks.h"

#include <algorithm>

#include "engine/anim/entity/ease_blender.h"

namespace throng::anim {
namespace {

std::size_t packet_floats(const UpdateContext& context) { return packet_bytes(context.components) / sizeof(float); }

}  // namespace

FusedTasks::Scratch FusedTasks::Scratch::carve(ScratchCarver& carver, const UpdateContext& context, int width) {
  Scratch scratch;
  scratch.model = ModelScratch::carve(carver, width, context.components, context.hierarchy->slot_count, true);
  scratch.stack = carver.carve<float>(packet_floats(context) * BlendTree::max_players);
  scratch.player_poses = carver.carve<PlayerPose>(static_cast<std::size_t>(width) * BlendTree::max_players);
  return scratch;
}

std::size_t FusedTasks::fetch_bytes(const UpdateContext& context, int width, std::uint32_t largest_player) {
  const std::uint32_t blender = context.pools->layout(EntityPools::ease_blenders).total_size;
  const std::uint32_t tree = largest_player * BlendTree::max_players + blender * (BlendTree::max_players - 1);
  return static_cast<std::size_t>(width) * tree;
}

std::size_t FusedTasks::scratch_bytes(const UpdateContext& context, int width) {
  ScratchCarver carver({});
  Scratch::carve(carver, context, width);
  return carver.used();
}

FusedTasks::FusedTasks(const UpdateContext& context, std::span<const AgentWork> work, std::span<const Tile> tiles,
                       TaskQueue::Taker queue, const LocalStore& store, int width, PaletteMatrix* unseen)
    : context_(&context), work_(work), tiles_(tiles), queue_(queue), store_(&store), width_(width), unseen_(unseen) {
  ScratchCarver carver(store.scratch());
  scratch_ = Scratch::carve(carver, context, width);
  std::ranges::fill(scratch_.model.local, 0.0F);  // lanes beyond the last character compute on numbers, not on noise
}

std::span<const AgentWork> FusedTasks::agents(int task) const {
  const Tile& tile = tiles_[static_cast<std::size_t>(task)];
  return work_.subspan(tile.first, tile.count);
}

void FusedTasks::fetch(int task, int buffer, CopyEngine& engine) const {
  std::byte* local = store_->fetch_buffer(buffer).data();
  for (const AgentWork& work : agents(task)) {
    for (const Handle handle : work.tree->all()) {
      const std::uint32_t size = context_->pools->layout(handle).total_size;
      engine.fetch(context_->pools->block(handle), local, size);
      local += size;
    }
  }
}

void FusedTasks::write_back(int task, int buffer, CopyEngine& engine) const {
  const std::byte* local = store_->fetch_buffer(buffer).data();
  for (const AgentWork& work : agents(task)) {
    for (const Handle handle : work.tree->all()) {
      const EntityLayout layout = context_->pools->layout(handle);
      engine.write_back(local + identity_bytes, context_->pools->block(handle) + identity_bytes,
                        layout.changed_bytes());
      local += layout.total_size;
    }
  }
}

int FusedTasks::copy_points(int task) const { return context_->packets(agents(task).front().level); }

void FusedTasks::advance_entities(std::span<const AgentWork> tile, std::byte* block) {
  PlayerPose* poses = scratch_.player_poses.data();
  for (const AgentWork& work : tile) {
    PlayerPose* pose = poses;
    for (const Handle handle : work.tree->all()) {
      const EntityLayout layout = context_->pools->layout(handle);
      reinterpret_cast<AnimationStateHeader*>(block)->delta_time += work.delta;
      if (handle.pool() == EntityPools::ease_blenders) {
        advance_blender(*reinterpret_cast<EaseBlender*>(block));
      } else {
        auto& player = *reinterpret_cast<Player*>(block);
        const ClipStreams& clip = context_->clips[player.clip];
        advance_player(player, clip);
        *pose++ = begin_pose(player, clip, {block + layout.private_offset, layout.private_bytes()});
      }
      block += layout.total_size;
    }
    poses += BlendTree::max_players;
  }
}

void FusedTasks::pose_character(const AgentWork& work, const std::byte* block, const PlayerPose* players, int packet,
                                float* local) const {
  const std::size_t stride = packet_floats(*context_);
  float* const stack = scratch_.stack.data();
  std::size_t depth = 0;
  for (const Handle handle : work.tree->all()) {
    const bool last = handle == work.tree->root();
    if (handle.pool() == EntityPools::ease_blenders) {
      const auto& blender = *reinterpret_cast<const EaseBlender*>(block);
      float* const from = stack + (depth - 2) * stride;
      blend_packet(blender, context_->mask(blender.mask), *context_->kernels, packet, from, from + stride,
                   last ? local : from);
      --depth;
    } else {
      pose_packet(*players++, *context_->kernels, context_->components, packet, last ? local : stack + depth * stride);
      ++depth;
    }
    block += context_->pools->layout(handle).total_size;
  }
}

void FusedTasks::compute(int task, int buffer, CopyEngine& engine) {
  const std::span<const AgentWork> tile = agents(task);
  std::byte* const blocks = store_->fetch_buffer(buffer).data();
  advance_entities(tile, blocks);
  begin_palettes(scratch_.model, tile, unseen_);
  const std::size_t stride = packet_floats(*context_);
  for (int packet = 0; packet < context_->packets(tile.front().level); ++packet) {
    const std::byte* block = blocks;
    for (std::size_t i = 0; i < tile.size(); ++i) {
      pose_character(tile[i], block, &scratch_.player_poses[i * BlendTree::max_players], packet,
                     scratch_.model.local.data() + i * stride);
      for (const Handle handle : tile[i].tree->all()) block += context_->pools->layout(handle).total_size;
    }
    model_palette_packet(*context_, scratch_.model, scratch_.model.local.data(), tile, width_, packet);
    engine.advance();
  }
  store_hashes(scratch_.model, tile);
  ++tiles_done_;
  agents_done_ += static_cast<std::uint32_t>(tile.size());
}

}  // namespace throng::anim
