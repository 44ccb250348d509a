#include "app/crowd/steering/obstacle_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace throng::app {
namespace {

constexpr float side_in_sights = 2.0F;
constexpr float most_squares = 65536.0F;  // of a ground that is large beside what is seen of it

}  // namespace

ObstacleMap::ObstacleMap(std::span<const Obstacle> obstacles, glm::vec2 lowest, glm::vec2 highest, float sight)
    : lowest_(lowest) {
  assert(sight > 0.0F && highest.x >= lowest.x && highest.y >= lowest.y);
  const glm::vec2 extent = highest - lowest;
  const float longest = std::max(extent.x, extent.y);
  const float side =
      std::max({side_in_sights * sight, std::sqrt(extent.x * extent.y / most_squares), longest / most_squares});
  squares_a_metre_ = 1.0F / side;
  squares_ = {static_cast<std::size_t>(extent.x * squares_a_metre_) + 1,
              static_cast<std::size_t>(extent.y * squares_a_metre_) + 1};
  list(obstacles, sight);
}

void ObstacleMap::list(std::span<const Obstacle> obstacles, float sight) {
  std::vector<std::vector<std::uint32_t>> seen(squares_.x * squares_.z);
  std::size_t listed = 0;
  for (std::uint32_t i = 0; i < obstacles.size(); ++i) {
    const glm::vec2 middle(obstacles[i].position);
    const float far = sight + static_cast<float>(obstacles[i].radius);
    for (std::size_t z = row(middle.y - far); z <= row(middle.y + far); ++z) {
      for (std::size_t x = column(middle.x - far); x <= column(middle.x + far); ++x, ++listed) {
        seen[z * squares_.x + x].push_back(i);
      }
    }
  }
  columns_.set_aside(listed);
  first_.push_back(0);
  for (const std::vector<std::uint32_t>& square : seen) {
    std::uint32_t at = first_.back();
    for (const std::uint32_t i : square) {
      write_body({.position = glm::vec2(obstacles[i].position), .radius = static_cast<float>(obstacles[i].radius)},
                 at++, columns_);
    }
    first_.push_back(at);
  }
}

}  // namespace throng::app
