#pragma once

#include <span>

#include "engine/anim/run/agent_work.h"
#include "engine/anim/run/local_store.h"
#include "engine/anim/run/task_queue.h"
#include "engine/anim/run/tile_scratch.h"

namespace throng::anim {

/// A tile: agents of one bone level, at most `width` of the plan.
struct Tile {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// The `fused` schedule: a task runs the whole trees of a tile's characters, players to palette, in
/// one stay in the local store. Blocks are transient: fetched whole, their changed bytes written back.
class FusedTasks {
 public:
  FusedTasks(const UpdateContext& context, std::span<const AgentWork> work, std::span<const Tile> tiles,
             TaskQueue::Taker queue, const LocalStore& store, int width, PaletteMatrix* unseen);

  static std::size_t fetch_bytes(const UpdateContext& context, int width, std::uint32_t largest_player);
  static std::size_t scratch_bytes(const UpdateContext& context, int width);

  std::optional<int> next() { return queue_.take(); }
  void fetch(int task, int buffer, CopyEngine& engine) const;
  int copy_points(int task) const;
  void compute(int task, int buffer, CopyEngine& engine);
  void write_back(int task, int buffer, CopyEngine& engine) const;

  std::uint32_t tiles_done() const { return tiles_done_; }
  std::uint32_t agents_done() const { return agents_done_; }

 private:
  struct Scratch {
    ModelScratch model;
    std::span<float> stack;              // [max_players][components][16], poses of one packet of one character
    std::span<PlayerPose> player_poses;  // [width][max_players]
    static Scratch carve(ScratchCarver& carver, const UpdateContext& context, int width);
  };

  std::span<const AgentWork> agents(int task) const;
  void advance_entities(std::span<const AgentWork> tile, std::byte* block);
  void pose_character(const AgentWork& work, const std::byte* block, const PlayerPose* players, int packet,
                      float* local) const;

  const UpdateContext* context_;
  std::span<const AgentWork> work_;
  std::span<const Tile> tiles_;
  TaskQueue::Taker queue_;
  const LocalStore* store_;
  int width_;
  PaletteMatrix* unseen_;
  Scratch scratch_;
  std::uint32_t tiles_done_ = 0;
  std::uint32_t agents_done_ = 0;
};

}  // namespace throng::anim
