#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/run/program/agent_work.h"
#include "engine/anim/run/program/pose_program.h"

namespace throng::anim {

/// What the steps of a program left behind, for those that read them.
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

/// Where a step of a character lies in the local store: its block, if it owns it, and what is prepared for it.
struct StepPlace {
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
  /// Of the character in the tile that is so many further on, after others who run the same program.
  StepPlace of_next(const PoseProgram& program, std::size_t characters = 1) const {
    return {.step = step,
            .block = block + characters * program.needs.fetch_bytes,
            .prepared = prepared + characters * program.needs.prepared_bytes};
  }
  /// From the first step.
  StepPlace at_tail(const PoseProgram& program) const {
    return {.step = program.tail,
            .block = block + program.blocks_before_tail,
            .prepared = prepared + program.prepared_before_tail};
  }
};

/// Calls visit(step index, step, entity) for each entity before the step `end` that the character owns, sources first,
/// and leaves `place` at `end`.
template <typename Visit>
void for_each_own(const UpdateContext& context, const PoseProgram& program, StepPlace& place, std::size_t end,
                  Visit&& visit) {
  while (place.step < end) {
    const PoseStep& step = program.steps[place.step];
    if (step.is_shared()) {
      ++place.step;
      continue;
    }
    const EntityLayout& layout = step.layout(*context.pools);
    visit(place.step, step, place.entity(context, layout));
    place.pass(layout);
  }
}

}  // namespace throng::anim
