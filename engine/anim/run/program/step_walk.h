#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/run/program/agent_work.h"
#include "engine/anim/run/program/pose_program.h"

namespace throng::anim {

/// The results that the steps of a program left behind, for the steps that read them.
template <typename Left>
struct LeftBySteps {
  std::array<Left, PoseProgram::max_steps> left;

  std::span<const Left> sources(const PoseStep& step, std::array<Left, max_sources>& gathered) const {
    for (std::size_t k = 0; k < step.source_count; ++k) gathered[k] = left[step.sources[k]];
    return {gathered.data(), step.source_count};
  }
};

template <typename Visit>
void for_each_shared(const PoseProgram& program, Visit&& visit) {
  if (program.needs.shared == 0) return;
  for (std::size_t i = 0; i < program.steps.size(); ++i) {
    if (program.steps[i].is_shared()) visit(i, program.steps[i]);
  }
}

/// A step of a character in the local store: its block, if the character owns it, and its prepared data.
struct StepCursor {
  std::size_t step = 0;
  std::byte* block = nullptr;
  std::byte* prepared = nullptr;

  EntityInStore entity(const UpdateContext& context, const EntityLayout& layout) const {
    return {.block = block, .prepared = prepared, .layout = &layout, .assets = &context.assets};
  }
  void pass(const EntityLayout& layout) {
    ++step;
    block += layout.total_size;
    prepared += layout.kind->prepared_bytes;
  }
  /// Returns the same step of a character further on in the tile, after so many that run this program.
  StepCursor of_next(const PoseProgram& program, std::size_t characters = 1) const {
    return {.step = step,
            .block = block + characters * program.needs.fetch_bytes,
            .prepared = prepared + characters * program.needs.prepared_bytes};
  }
  /// Returns the first step of the tail; this cursor is at the first step of all.
  StepCursor at_tail(const PoseProgram& program) const {
    return {.step = program.tail,
            .block = block + program.blocks_before_tail,
            .prepared = prepared + program.prepared_before_tail};
  }
};

/// Returns the number of steps before `step` whose entities the character owns.
inline std::size_t own_steps_before(const PoseProgram& program, std::size_t step) {
  if (program.needs.shared == 0) return step;
  const auto is_own = [](const PoseStep& one) { return !one.is_shared(); };
  return static_cast<std::size_t>(std::ranges::count_if(std::span(program.steps).first(step), is_own));
}

/// Calls visit(step index, step, entity) for each entity before the step `end` that the character owns, sources first,
/// and leaves `cursor` at `end`.
template <typename Visit>
void for_each_own(const UpdateContext& context, const PoseProgram& program, StepCursor& cursor, std::size_t end,
                  Visit&& visit) {
  while (cursor.step < end) {
    const PoseStep& step = program.steps[cursor.step];
    if (step.is_shared()) {
      ++cursor.step;
      continue;
    }
    const EntityLayout& layout = step.layout(*context.pools);
    visit(cursor.step, step, cursor.entity(context, layout));
    cursor.pass(layout);
  }
}

}  // namespace throng::anim
