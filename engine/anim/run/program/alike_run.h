#pragma once

#include <cstddef>
#include <span>

#include "engine/anim/run/program/agent_work.h"

namespace throng::anim {

/// Characters of a tile that follow each other and whose graphs look alike.
struct AlikeRun {
  std::size_t first;
  std::size_t end;
  const PoseProgram* program;

  std::size_t size() const { return end - first; }
};

/// Calls visit(AlikeRun) for each, in order; none can be made longer. `program`: of all, where that is known, or null.
template <typename Visit>
void for_each_alike(std::span<const AgentWork> tile, const PoseProgram* program, Visit&& visit) {
  if (program != nullptr) return visit(AlikeRun{0, tile.size(), program});
  for (std::size_t first = 0, end = 0; first < tile.size(); first = end) {
    program = tile[first].program;
    for (end = first + 1; end < tile.size() && tile[end].program == program;) ++end;
    visit(AlikeRun{first, end, program});
  }
}

}  // namespace throng::anim
