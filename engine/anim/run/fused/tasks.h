#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engine/anim/run/fused/scratch.h"
#include "engine/anim/run/fused/strip_poses.h"
#include "engine/anim/run/fused/tile_copies.h"
#include "engine/anim/run/fused/tile_lists.h"
#include "engine/anim/run/program/task_content.h"
#include "engine/anim/run/store/copy_engine.h"
#include "engine/anim/run/store/local_store.h"
#include "engine/anim/run/store/strip_palettes.h"
#include "engine/anim/run/store/task_queue.h"

namespace throng::anim {

/// The `fused` schedule: a task runs the whole graphs of the characters of a tile, from players to palettes, in one
/// stay in the local store. Here are the steps of a tile, in this order, and why.
///
/// 1. *Fetch* (tile_copies.h). Of each block come the bytes that its updates read: for a player that shows a clip
///    one line of 64 bytes. The poses of players and blenders are transient and never leave the store. That is why this
///    schedule moves a fraction of what `levels` moves. With double buffering the next tile is fetched while this one
///    is computed, so fetch() may touch nothing but its own fetch buffer and its own list of origins.
/// 2. *Advance* (advance.h). All entities of the tile move by the time that passed, step by step for all characters of
///    a run: one call of a kind advances many, and their updates overlap. Sources stand before their readers in a
///    program, so one pass in the order of the steps is enough. An entity says here which clips it shows. It reads
///    and writes its own block and its prepared bytes, and reads its sources; no pose exists yet.
/// 3. *Write back what is final* (tile_copies.h). Posing does not change the blocks of most kinds, so they go back to
///    main memory now, while they are still in L1.
/// 4. *Find out what each strip shows* (strip_poses.h). Kernels pose up to 16 characters side by side, which is a
///    strip; a tile has up to two. Most characters show clips, and one kernel poses these for the whole strip. The
///    others are composed over them. All that packets need is looked up here, because kernels leave nothing in L1 but
///    what they work on.
/// 5. *Pose held packets* (pose_strip.h), in held tiles alone. A gaze or a limb that reaches needs bones of several
///    packets at once, so the first packets of all characters are posed, kept, changed, and then made palettes.
/// 6. *Pose streaming* (pose_strip.h). The other packets go from rows of clips to palettes one by one, 16 bones of
///    all characters at a time. A pose of 62 bones has four packets, and scratch holds one of each character; that is
///    why a tile of this width fits the store.
/// 7. *Palettes* (strip_palettes.h) are written packet by packet in 5 and 6, in ascending order, because a bone needs
///    its parent's transform. They go straight to where the renderer reads them. After each packet the copy engine
///    moves a slice of the tiles before and behind this one.
/// 8. *Write back* the blocks that posing changed, while the next tile is computed.
///
/// Whatever tile, strip or neighbours a character has, its bits are the same: nothing here sums over characters.
class FusedTasks {
 public:
  FusedTasks(std::span<const UpdateContext> contexts, std::span<const AgentWork> work, const CutWork& cut,
             TaskQueue::Taker queue, const LocalStore& store, TileLists& lists, const PaletteStores& stores,
             BlockChanges changes = BlockChanges::written_back)
      : contexts_(contexts),
        work_(work),
        cut_(cut),
        queue_(queue),
        store_(&store),
        stores_(stores),
        lists_(&lists),
        copies_(lists, changes) {}

  std::optional<int> next() { return queue_.take(); }
  void fetch(int task, int buffer, CopyEngine& engine);
  int copy_points(int task) const;
  void compute(int task, int buffer, CopyEngine& engine);
  void write_back(int task, int buffer, CopyEngine& engine) const;

  TaskContent content(int task) const { return content_of(agents(task)); }

  std::uint32_t tiles_done() const { return tiles_done_; }
  std::uint32_t agents_done() const { return agents_done_; }

 private:
  /// The tile for which the scratch is divided.
  struct Divided {
    const UpdateContext* context = nullptr;
    StoreNeeds needs = {};
    int width = 0;
    std::size_t characters = 0;

    friend bool operator==(const Divided&, const Divided&) = default;
  };

  const Tile& tile(int task) const { return cut_.tiles[static_cast<std::size_t>(task)]; }
  std::span<const AgentWork> agents(int task) const { return work_.subspan(tile(task).first, tile(task).count); }
  std::span<const AgentWork> agents_behind(int task, std::size_t tasks) const;
  const UpdateContext& context(int task) const { return contexts_[agents(task).front().skeleton]; }
  TileInStore in_store(int task, int buffer) const;
  void divide_scratch(const Divided& wanted);
  void pose(const Strip& strip, StepCursor& first, CopyEngine& engine);

  std::span<const UpdateContext> contexts_;
  std::span<const AgentWork> work_;
  CutWork cut_;
  TaskQueue::Taker queue_;
  const LocalStore* store_;
  PaletteStores stores_;
  TileLists* lists_;
  TileCopies copies_;
  Divided divided_;
  FusedScratch scratch_;
  SharedSources shared_;  // the shared sources of the tile that is computed, if it reads any
  StripPoses poses_;      // the poses of the strip that is posed
  std::uint32_t tiles_done_ = 0;
  std::uint32_t agents_done_ = 0;
};

}  // namespace throng::anim
