#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/run/fused/clip_strip.h"
#include "engine/anim/run/fused/composed_run.h"
#include "engine/anim/run/fused/tile_in_store.h"
#include "engine/anim/run/fused/tile_lists.h"

namespace throng::anim {

/// The parts that the poses of a strip are made of, found once before its first packet. Most characters show clips,
/// which one kernel poses for all of them. Other poses are composed: first the head of the program, entity by entity,
/// then its tail, side by side with others (TailRounds).
class StripPoses {
 public:
  /// Finds the parts. `first` is the first step of the first character; it is left at the first step behind the last
  /// character.
  void find(const Strip& strip, TileLists& lists, StepCursor& first);

  const ClipStrip& clips() const { return clips_; }
  const TailRounds& tails() const { return *tails_; }
  bool any_composed() const { return composed_count_ > 0; }
  bool any_heads() const {
    return std::ranges::any_of(composed(), [](const ComposedRun& run) { return !run.tail_over_clips; });
  }
  /// Returns the quads whose bones may have positions other than 0.
  std::uint64_t displaced_quads() const { return composed_displaces_ | clips_.displaced_quads(); }

  /// Returns the packets of a character, as far as they are held.
  PoseView pose(const Strip& strip, std::size_t character) const {
    const UpdateContext& context = strip.context();
    return {strip.pose(character), strip.held_stride(), context.assets.components,
            context.bones(strip.work.front().level), displaced_quads()};
  }

  /// Calls visit(run, character, its first step) for each character that has more than a tail over clips.
  template <typename Visit>
  void for_each_head(Visit&& visit) const {
    for (const ComposedRun& run : composed()) {
      if (run.tail_over_clips) continue;
      StepCursor cursor = run.head;
      for (std::size_t character = run.characters.first; character < run.characters.end(); ++character) {
        visit(run, character, cursor);
        cursor = cursor.of_next(run.program());
      }
    }
  }

 private:
  std::span<const ComposedRun> composed() const { return std::span(composed_).first(composed_count_); }
  void find_composed(const Strip& strip, const ShownBySteps& shown, const AgentRun& run, StepCursor cursor);
  ComposedRun& begin_composed(const UpdateContext& context, const AgentRun& first, const StepCursor& cursor,
                              std::size_t base);

  ClipStrip clips_;
  std::array<ComposedRun, widest_strip> composed_;
  std::size_t composed_count_ = 0;
  std::uint64_t composed_displaces_ = 0;  // quads that get their positions from more than clips
  TailRounds* tails_ = nullptr;
};

}  // namespace throng::anim
