#include "app/crowd/steering/cells.h"

#include <cassert>
#include <cmath>

namespace throng::app {

void CrowdCells::set_aside(std::size_t bodies, glm::vec2 lowest, glm::vec2 highest, float reach) {
  assert(reach > 0.0F && highest.x >= lowest.x && highest.y >= lowest.y);
  lowest_ = lowest;
  reach_ = reach;
  const glm::vec2 extent = highest - lowest;
  // A few bodies strewn far apart get larger cells, not more of them than four a body.
  const float most_cells = 4.0F * static_cast<float>(bodies) + 64.0F;
  const float side = std::max(0.5F * reach, std::sqrt(extent.x * extent.y / most_cells));
  cells_per_metre_ = 1.0F / std::max(side, std::max(extent.x, extent.y) / most_cells);
  columns_ = static_cast<std::size_t>(extent.x * cells_per_metre_) + 1;
  rows_ = static_cast<std::size_t>(extent.y * cells_per_metre_) + 1;
  first_.assign(columns_ * rows_ + 1, 0);
  cells_.assign(bodies, 0);
  order_.assign(bodies, 0);
  sorted_.assign(bodies, Body{});
}

void CrowdCells::sort(std::span<const Body> bodies) {
  anim::InOrder here;
  sort(bodies, here, 1, [](const Body&, std::size_t) {});
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
