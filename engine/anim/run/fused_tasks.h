#pragma once

#include <array>
#include <span>

#include "engine/anim/run/agent_work.h"
#include "engine/anim/run/fused_scratch.h"
#include "engine/anim/run/local_store.h"
#include "engine/anim/run/task_queue.h"
#include "engine/anim/run/tile_scratch.h"

namespace throng::anim {

/// The `fused` schedule: a task runs the whole graphs of a tile's characters, players to palette, in one stay in the
/// local store. Blocks are fetched whole, their changed bytes written back; a shared source is fetched once a tile and
/// never written back.
///
///     fetch buffer   [blocks of character 0 in the order of its steps | of character 1 | ... | shared sources]
///
/// A *streaming* tile takes 16 bones at a time from rows to palette. A *held* one, where some entity needs bones of
/// several packets, keeps each character's whole local pose first. Both give the same bits.
class FusedTasks {
 public:
  FusedTasks(std::span<const UpdateContext> contexts, std::span<const AgentWork> work, std::span<const Tile> tiles,
             TaskQueue::Taker queue, const LocalStore& store, PaletteMatrix* unseen)
      : contexts_(contexts), work_(work), tiles_(tiles), queue_(queue), store_(&store), unseen_(unseen) {}

  std::optional<int> next() { return queue_.take(); }
  void fetch(int task, int buffer, CopyEngine& engine) const;
  int copy_points(int task) const;
  void compute(int task, int buffer, CopyEngine& engine);
  void write_back(int task, int buffer, CopyEngine& engine) const;

  std::uint32_t tiles_done() const { return tiles_done_; }
  std::uint32_t agents_done() const { return agents_done_; }

 private:
  struct Characters;

  std::span<const AgentWork> agents(int task) const;
  const UpdateContext& context(int task) const { return contexts_[agents(task).front().skeleton]; }
  void advance_entities(const Characters& characters) const;
  void compute_streaming(const Characters& characters, CopyEngine& engine) const;
  void compute_held(const Characters& characters, CopyEngine& engine) const;
  void stream_packet(const Characters& characters, int packet) const;
  void hold_pose(const Characters& characters, const AgentWork& work, const PoseView& held, std::byte*& block,
                 std::byte*& prepared) const;

  std::span<const UpdateContext> contexts_;
  std::span<const AgentWork> work_;
  std::span<const Tile> tiles_;
  TaskQueue::Taker queue_;
  const LocalStore* store_;
  PaletteMatrix* unseen_;
  FusedScratch scratch_;
  std::uint32_t tiles_done_ = 0;
  std::uint32_t agents_done_ = 0;
};

}  // namespace throng::anim
