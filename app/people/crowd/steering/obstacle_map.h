#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "app/people/crowd/steering/cells.h"
#include "app/people/crowd/steering/ground_grid.h"
#include "app/people/crowd/steering/near_bodies.h"
#include "app/people/crowd/steering/obstacle.h"

namespace throng::app {

/// Tells which obstacles are in sight from each place. It never changes, so it keeps a list for each cell of a grid,
/// and an agent looks through one run of bodies alone. An obstacle lies in the lists of all cells from which it can be
/// seen.
class ObstacleMap {
 public:
  /// An agent sees as far as `sight` metres beyond the edge of an obstacle. Agents are between `lowest` and `highest`
  /// as a rule; elsewhere they see too.
  ObstacleMap(std::span<const Obstacle> obstacles, glm::vec2 lowest, glm::vec2 highest, float sight);

  /// Returns the obstacles as bodies that stand, each once a cell.
  const BodyColumns& columns() const { return columns_; }
  /// Returns the runs of columns() that hold all that is in sight of `position`, and some beyond it: one at most.
  CellRuns runs_near(glm::vec2 position) const {
    const std::size_t at = grid_.cell(position);
    CellRuns runs;
    if (first_[at] != first_[at + 1]) runs.all[runs.count++] = {first_[at], first_[at + 1]};
    return runs;
  }

 private:
  GroundGrid grid_;
  std::vector<std::uint32_t> first_;  // [cell] where its list begins; one more element marks the end
  BodyColumns columns_;
};

}  // namespace throng::app
