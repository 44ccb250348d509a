#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include <glm/vec2.hpp>

namespace throng::app {

/// A grid of square cells over the ground, row by row. Places beyond the edge belong to the cells along it.
struct GroundGrid {
  glm::vec2 lowest{0.0F};  ///< metres, the corner of the first cell
  float cells_per_metre = 1.0F;
  std::size_t columns = 1, rows = 1;

  GroundGrid() = default;
  /// Covers the ground from `lowest` to `highest` with cells whose sides are `least_side` metres; longer where that
  /// would be more cells than about `most_cells`.
  GroundGrid(glm::vec2 from, glm::vec2 highest, float least_side, float most_cells) : lowest(from) {
    assert(least_side > 0.0F && highest.x >= lowest.x && highest.y >= lowest.y);
    const glm::vec2 extent = highest - lowest;
    const float side = std::max(least_side, std::sqrt(extent.x * extent.y / most_cells));
    cells_per_metre = 1.0F / std::max(side, std::max(extent.x, extent.y) / most_cells);
    columns = static_cast<std::size_t>(extent.x * cells_per_metre) + 1;
    rows = static_cast<std::size_t>(extent.y * cells_per_metre) + 1;
  }

  std::size_t cell_count() const { return columns * rows; }
  std::size_t column(float x) const { return clamped((x - lowest.x) * cells_per_metre, columns); }
  std::size_t row(float z) const { return clamped((z - lowest.y) * cells_per_metre, rows); }
  std::size_t cell(glm::vec2 position) const { return row(position.y) * columns + column(position.x); }

 private:
  static std::size_t clamped(float cells, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(cells, 0.0F, static_cast<float>(count - 1)));
  }
};

}  // namespace throng::app
