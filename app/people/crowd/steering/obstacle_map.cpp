#include "app/people/crowd/steering/obstacle_map.h"

namespace throng::app {
namespace {

constexpr float side_in_sights = 2.0F;
constexpr float most_cells = 65536.0F;  // of a ground that is large beside the sight of an agent

}  // namespace

ObstacleMap::ObstacleMap(std::span<const Obstacle> obstacles, glm::vec2 lowest, glm::vec2 highest, float sight)
    : grid_(lowest, highest, side_in_sights * sight, most_cells) {
  std::vector<std::vector<std::uint32_t>> seen(grid_.cell_count());
  std::size_t listed = 0;
  for (std::uint32_t i = 0; i < obstacles.size(); ++i) {
    const glm::vec2 middle(obstacles[i].position);
    const float far = sight + static_cast<float>(obstacles[i].radius);
    for (std::size_t row = grid_.row(middle.y - far); row <= grid_.row(middle.y + far); ++row) {
      for (std::size_t column = grid_.column(middle.x - far); column <= grid_.column(middle.x + far); ++column) {
        seen[row * grid_.columns + column].push_back(i);
        ++listed;
      }
    }
  }
  columns_.set_aside(listed);
  first_.push_back(0);
  for (const std::vector<std::uint32_t>& cell : seen) {
    std::uint32_t at = first_.back();
    for (const std::uint32_t i : cell) {
      write_body({.position = glm::vec2(obstacles[i].position), .radius = static_cast<float>(obstacles[i].radius)},
                 at++, columns_);
    }
    first_.push_back(at);
  }
}

}  // namespace throng::app
