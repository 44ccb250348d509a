#include "app/people/crowd/steering/obstacle_map.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/base/random.h"

namespace throng::app::obstacle_map_test {
namespace {

constexpr float sight = 4.0F;

bool is_listed(const ObstacleMap& map, glm::vec2 from, glm::vec2 middle) {
  const CellRuns near = map.runs_near(from);
  for (const BodyRun& run : near.runs()) {
    for (std::uint32_t body = run.first; body < run.end; ++body) {
      if (glm::vec2(map.columns().x[body], map.columns().z[body]) == middle) return true;
    }
  }
  return false;
}

TEST(ObstacleMap, ListsAllThatIsInSightAlsoFromBeyondTheEdge) {
  Random random(3, 1);
  std::vector<Obstacle> obstacles;
  for (int i = 0; i < 60; ++i) {
    obstacles.push_back({.position = {random.between(-60.0F, 60.0F), random.between(-60.0F, 60.0F)},
                         .radius = static_cast<double>(random.between(0.2F, 7.0F))});
  }
  const ObstacleMap map(obstacles, glm::vec2(-40.0F), glm::vec2(40.0F), sight);
  int in_sight = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::vec2 from(random.between(-70.0F, 70.0F), random.between(-70.0F, 70.0F));
    for (const Obstacle& obstacle : obstacles) {
      const glm::vec2 middle(obstacle.position);
      if (glm::distance(from, middle) > sight + static_cast<float>(obstacle.radius)) continue;
      ++in_sight;
      EXPECT_TRUE(is_listed(map, from, middle));
    }
  }
  EXPECT_GT(in_sight, 500);
}

TEST(ObstacleMap, ListsLittleElse) {
  std::vector<Obstacle> obstacles;
  for (int i = 0; i < 100; ++i) obstacles.push_back({.position = {i * 10.0, 0.0}, .radius = 0.5});
  const ObstacleMap map(obstacles, glm::vec2(0.0F), glm::vec2(1000.0F, 1.0F), sight);
  for (float x = 0.0F; x < 1000.0F; x += 7.0F) {
    const CellRuns near = map.runs_near({x, 0.0F});
    for (const BodyRun& run : near.runs()) EXPECT_LE(run.end - run.first, 3U);
  }
}

}  // namespace
}  // namespace throng::app::obstacle_map_test
