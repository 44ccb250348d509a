#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "engine/anim/run/fused/clip_strip.h"
#include "engine/anim/run/fused/notes.h"
#include "engine/anim/run/fused/scratch.h"
#include "engine/anim/run/program/alike_run.h"
#include "engine/anim/run/program/shared_sources.h"
#include "engine/anim/run/program/step_walk.h"
#include "engine/anim/run/program/task_content.h"
#include "engine/anim/run/store/copy_engine.h"
#include "engine/anim/run/store/local_store.h"
#include "engine/anim/run/store/strip_palettes.h"
#include "engine/anim/run/store/task_queue.h"

namespace throng::anim {

/// What becomes of the blocks that an update has changed in the local store.
enum class BlockChanges : std::uint8_t {
  written_back,
  dropped,  ///< the update was a look at what would be: entities stay where they stand
};

/// The `fused` schedule: a task runs the whole graphs of a tile's characters, players to palette, in one stay in the
/// local store. Of a block, what updates of its kind read is fetched, and what they change is written back; a shared
/// source is fetched once a tile and never written back.
///
///     fetch buffer   [blocks of character 0 in the order of its steps | of character 1 | ... | shared sources]
///
/// A *streaming* tile takes 16 bones at a time from rows to palette. A *held* one, where some entity needs bones of
/// several packets, keeps these of all characters first and streams the rest; entities of one kind that change poses
/// where they lie do so side by side, for many characters at once. Both give the same bits.
class FusedTasks {
 public:
  FusedTasks(std::span<const UpdateContext> contexts, std::span<const AgentWork> work, std::span<const Tile> tiles,
             TaskQueue::Taker queue, const LocalStore& store, FusedNotes& notes, const PaletteStores& stores,
             BlockChanges changes = BlockChanges::written_back)
      : contexts_(contexts),
        work_(work),
        tiles_(tiles),
        queue_(queue),
        store_(&store),
        stores_(stores),
        changes_(changes),
        notes_(&notes) {}

  std::optional<int> next() { return queue_.take(); }
  void fetch(int task, int buffer, CopyEngine& engine);
  int copy_points(int task) const;
  void compute(int task, int buffer, CopyEngine& engine);
  void write_back(int task, int buffer, CopyEngine& engine) const;

  TaskContent content(int task) const { return content_of(agents(task)); }

  std::uint32_t tiles_done() const { return tiles_done_; }
  std::uint32_t agents_done() const { return agents_done_; }

 private:
  struct Characters;
  /// Characters that follow each other and run the same program, whose poses are not clips alone, but may begin with
  /// some.
  struct Composed {
    static constexpr std::size_t no_base = PoseProgram::max_steps;

    AlikeRun characters;
    StepPlace head;            ///< the first step of the first one
    StepPlace tail;            ///< and the first of its tail that is not in a round yet
    std::size_t base;          ///< step that the kernel for clips poses, or no_base
    bool over_clips = false;   ///< nothing but steps of the tail is posed over the base
    std::uint64_t wanted = 0;  ///< where there is more: bit i: step i is posed, or is the base

    const PoseProgram& program() const { return *characters.program; }
    bool poses(std::size_t step) const { return step != base && (wanted >> step & 1U) != 0; }
  };

  /// Calls visit(composed, character, its first step) for those with more than a tail over clips.
  template <typename Visit>
  void for_each_head(Visit&& visit) const {
    for (const Composed& composed : std::span(composed_).first(composed_count_)) {
      if (composed.over_clips) continue;
      StepPlace place = composed.head;
      for (std::size_t c = composed.characters.first; c < composed.characters.end; ++c) {
        visit(composed, c, place);
        place = place.of_next(composed.program());
      }
    }
  }

  bool has_heads() const {
    const auto is_head = [](const Composed& composed) { return !composed.over_clips; };
    return std::ranges::any_of(std::span(composed_).first(composed_count_), is_head);
  }

  /// For whom the scratch is carved.
  struct Carved {
    const UpdateContext* context = nullptr;
    StoreNeeds needs = {};
    int width = 0;
    std::size_t characters = 0;

    friend bool operator==(const Carved&, const Carved&) = default;
  };

  const Tile& tile_of(int task) const { return tiles_[static_cast<std::size_t>(task)]; }
  std::span<const AgentWork> agents(int task) const;
  /// As many as the task has, so many tasks behind its own.
  std::span<const AgentWork> agents_behind(int task, std::size_t tasks) const;
  const UpdateContext& context(int task) const { return contexts_[agents(task).front().skeleton]; }
  template <typename Visit>
  void for_each_row_to_go_home(int task, int buffer, Visit&& visit) const;
  void write_back_final_rows(int task, int buffer, CopyEngine& engine);
  void carve_scratch(const Carved& wanted);
  void advance_entities(const Characters& tile, StepPlace place);
  void advance_alike(const Characters& tile, const AlikeRun& alike, StepPlace place);
  std::span<ShownClips> shown_by(std::size_t step, const AlikeRun& alike);
  void plan_poses(const Characters& strip, StepPlace& place);
  void pose(const Characters& strip, CopyEngine& engine);
  void find_composed(const Characters& characters, const AlikeRun& alike, StepPlace place);
  Composed& begin_composed(const Characters& characters, const AlikeRun& first, const StepPlace& place,
                           std::size_t base);
  /// By a character of the strip that is posed.
  ShownClips& shown(std::size_t step, std::size_t character) {
    return notes_->shown[step * most_characters + posed_ + character];
  }
  void compute_streaming(const Characters& characters, StripPalettes& palettes, CopyEngine& engine) const;
  void compute_held(const Characters& characters, StripPalettes& palettes, CopyEngine& engine);
  void compose_packet(const Characters& characters, const Composed& composed, std::size_t character, StepPlace place,
                      int packet) const;
  void compose_streamed_packet(const Characters& characters, int packet) const;
  std::size_t base_of(const PoseProgram& program, std::size_t character);
  static std::uint64_t quads_displaced_by_head(const EntityPools& pools, const Composed& composed);
  std::uint64_t displaced_quads() const;
  std::size_t held_stride(const Characters& characters) const;
  std::span<float> held_packet(const Characters& characters, int packet) const;
  void pose_held_clips(const Characters& characters, int packet) const;
  PoseView pose_of(const Characters& characters, std::size_t character) const;
  void compose_head(const Characters& characters, const Composed& composed, std::size_t character,
                    StepPlace place) const;
  using EndOfSteps = std::size_t (*)(const PoseProgram& program);
  void add_rounds(const Characters& characters, EndOfSteps end);
  void plan_tails(const Characters& characters);
  void pose_whole_tails(const Characters& characters) const;
  void pose_held_tails(const Characters& characters, int packet) const;
  PosedEntities tail_round(const Characters& characters, std::size_t round) const;
  void pose_streamed_tails(const Characters& characters, int packet) const;

  std::span<const UpdateContext> contexts_;
  std::span<const AgentWork> work_;
  std::span<const Tile> tiles_;
  TaskQueue::Taker queue_;
  const LocalStore* store_;
  PaletteStores stores_;
  BlockChanges changes_;
  FusedScratch scratch_;
  Carved carved_;
  SharedSources shared_;  // of the tile that is computed, where it reads any
  FusedNotes* notes_;
  std::array<std::size_t, 2> homes_{};  // [fetch buffer] which of the lists of homes is that of its tile
  std::size_t next_homes_ = 0;
  std::array<bool, 2> rows_left_{};              // [fetch buffer] some are written back when its tile is done
  std::size_t posed_ = 0;                        // characters of the tile before the strip that is posed
  ClipStrip clips_;                              // what those of the strip show
  std::array<Composed, widest_strip> composed_;  // those that show more than clips
  std::size_t composed_count_ = 0;
  std::size_t whole_rounds_ = 0;          // rounds of tails that come first, for all held packets
  std::uint64_t composed_displaces_ = 0;  // quads whose positions come from more than clips
  std::uint32_t tiles_done_ = 0;
  std::uint32_t agents_done_ = 0;
};

}  // namespace throng::anim
