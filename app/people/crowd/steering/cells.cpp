#include "app/people/crowd/steering/cells.h"

#include <algorithm>

namespace throng::app {

void CrowdCells::set_aside(std::size_t bodies, glm::vec2 lowest, glm::vec2 highest, float reach) {
  // A few bodies strewn far apart get larger cells: four cells a body at most.
  const float most_cells = 4.0F * static_cast<float>(bodies) + 64.0F;
  grid_ = GroundGrid(lowest, highest, 0.5F * reach, most_cells);
  reach_ = reach;
  first_.assign(grid_.cell_count() + 1, 0);
  cells_.assign(bodies, 0);
  order_.assign(bodies, 0);
  sorted_.assign(bodies, Body{});
}

void CrowdCells::sort(std::span<const Body> bodies) {
  InOrder here;
  sort(
      bodies, here, 1, [](std::size_t, std::size_t) {}, [](const Body&, std::size_t) {});
}

// Counting is quick beside all else, so one thread does it.
void CrowdCells::find_order() {
  std::ranges::fill(first_, 0U);
  for (const std::uint32_t cell : cells_) ++first_[cell];
  std::uint32_t end = 0;
  for (std::uint32_t& first : first_) first = end += first;
  for (std::size_t body = cells_.size(); body-- > 0;) order_[--first_[cells_[body]]] = static_cast<std::uint32_t>(body);
}

}  // namespace throng::app
