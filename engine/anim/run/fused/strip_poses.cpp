#include "engine/anim/run/fused/strip_poses.h"

namespace throng::anim {
namespace {

/// Returns the steps that have to be posed where `base` already is: bit i is step i.
template <typename IsPosed>
std::uint64_t steps_over(const PoseProgram& program, std::size_t base, IsPosed&& is_posed) {
  static_assert(PoseProgram::max_steps <= 64);
  std::uint64_t wanted = std::uint64_t{1} << (program.steps.size() - 1);
  for (std::size_t i = program.steps.size(); i-- > 0;) {
    const PoseStep& step = program.steps[i];
    if ((wanted >> i & 1U) == 0 || i == base || is_posed(i)) continue;
    for (std::size_t k = 0; k < step.source_count; ++k) wanted |= std::uint64_t{1} << step.sources[k];
  }
  return wanted;
}

/// Returns the last step that shows clips and is read by steps that show none, or no_base. It is never the last step of
/// the program. `character`: of the tile.
std::size_t base_of(const PoseProgram& program, const ShownBySteps& shown, std::size_t character) {
  const auto shows_clips = [&](std::size_t i) {
    return !program.steps[i].is_shared() && shown.of(own_steps_before(program, i), character).clip != nullptr;
  };
  const std::size_t root = program.steps.size() - 1;
  for (std::size_t i = root; i-- + 1 > program.tail;) {
    if (shows_clips(i)) return i;
  }
  const auto is_posed = [&](std::size_t i) { return i != root && shows_clips(i); };
  const std::uint64_t wanted = steps_over(program, ComposedRun::no_base, is_posed);
  for (std::size_t i = root; i-- > 0;) {
    if ((wanted >> i & 1U) != 0 && shows_clips(i)) return i;
  }
  return ComposedRun::no_base;
}

/// Returns the quads in which a step before the tail may give bones other positions than the clips below it do.
std::uint64_t quads_displaced_by_head(const EntityPools& pools, const ComposedRun& run) {
  constexpr std::uint64_t all = ~std::uint64_t{0};
  if (run.base == ComposedRun::no_base) return all;
  std::uint64_t quads = 0;
  for (std::size_t i = 0; i < run.program().tail; ++i) {
    const PoseStep& step = run.program().steps[i];
    if (run.poses(i)) quads |= step.is_shared() ? all : step.layout(pools).kind->displaced_quads;
  }
  return quads;
}

}  // namespace

void StripPoses::find(const Strip& strip, TileLists& lists, StepCursor& first) {
  const ShownBySteps shown = lists.shown_by(strip.tile->work.size());
  clips_.begin(shown.last.subspan(strip.first, strip.work.size()));
  composed_count_ = 0;
  composed_displaces_ = 0;
  for_each_run(strip.tile->runs, strip.first, strip.work.size(), [&](const AgentRun& run) {
    if (!clips_.all_show(run.first, run.end())) find_composed(strip, shown, run, first);
    clips_.add(run.first, run.end());
    first = first.of_next(*run.program, run.count);
  });
  tails_ = &lists.tails;
  tails_->sort(strip, std::span(composed_).first(composed_count_));
  composed_displaces_ |= tails_->displaced_quads();
}

/// A character that is composed as the one before it joins that one's run.
void StripPoses::find_composed(const Strip& strip, const ShownBySteps& shown, const AgentRun& run, StepCursor cursor) {
  ComposedRun* newest = nullptr;
  for (std::uint32_t character = run.first; character < run.end(); ++character) {
    if (clips_.of(character).clip == nullptr) {
      const std::size_t in_tile = strip.first + character;
      const std::size_t base = base_of(*run.program, shown, in_tile);
      if (base != ComposedRun::no_base) clips_.of(character) = shown.of(own_steps_before(*run.program, base), in_tile);
      if (newest != nullptr && newest->characters.end() == character && newest->base == base) {
        ++newest->characters.count;
      } else {
        newest = &begin_composed(strip.context(), {run.program, character, 1}, cursor, base);
      }
    }
    cursor = cursor.of_next(*run.program);
  }
}

ComposedRun& StripPoses::begin_composed(const UpdateContext& context, const AgentRun& first, const StepCursor& cursor,
                                        std::size_t base) {
  const PoseProgram& program = *first.program;
  ComposedRun& run = composed_[composed_count_++];
  run = {.characters = first,
         .head = cursor,
         .tail = cursor.at_tail(program),
         .base = base,
         .tail_over_clips = base != ComposedRun::no_base && base + 1 >= program.tail};
  if (run.tail_over_clips) {
    for_each_own(context, program, run.tail, base + 1, [](auto&&...) {});
    return run;
  }
  run.wanted = steps_over(program, base, [](std::size_t) { return false; });
  composed_displaces_ |= quads_displaced_by_head(*context.pools, run);
  return run;
}

}  // namespace throng::anim
