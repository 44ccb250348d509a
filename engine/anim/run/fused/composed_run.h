#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/anim/run/program/step_walk.h"
#include "engine/anim/run/program/tile.h"

namespace throng::anim {

/// Characters of a strip that follow each other, run one program, and have poses that are more than clips. A composed
/// pose may begin with clips; then the kernel for clips poses the step `base`, and the steps over it change that pose.
struct ComposedRun {
  static constexpr std::size_t no_base = PoseProgram::max_steps;

  AgentRun characters;           ///< they count from the first of the strip
  StepCursor head;               ///< the first step of the first character
  StepCursor tail;               ///< the first step of its tail that no round has yet
  std::size_t base = no_base;    ///< the step that the kernel for clips poses, or no_base
  bool tail_over_clips = false;  ///< only steps of the tail are posed over the base
  std::uint64_t wanted = 0;      ///< bit i: step i is posed, or is the base; of use where there is more than a tail

  const PoseProgram& program() const { return *characters.program; }
  bool poses(std::size_t step) const { return step != base && (wanted >> step & 1U) != 0; }
};

}  // namespace throng::anim
