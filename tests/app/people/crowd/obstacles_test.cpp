#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "app/people/crowd/layout.h"
#include "app/people/crowd/steering/steering.h"
#include "engine/anim/run/pu_threads.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::obstacles_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;

/// Metres by which the nearest of the agents is outside of the nearest obstacle.
double least_room(const Crowd& crowd, const CrowdLayout& layout) {
  double least = 1e9;
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    const glm::vec3 at = crowd.positions()[agent];
    for (const Obstacle& obstacle : layout.obstacles) {
      least = std::min(least, glm::distance(obstacle.position, glm::dvec2(at.x, at.z)) - obstacle.radius);
    }
  }
  return least;
}

TEST(Obstacles, HaveNobodyInThemInAnyFrameOfAMinute) {
  for (const std::size_t agents : {10U, 100U, 300U, 1000U}) {
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
      const CrowdLayout layout = plaza_layout(agents, seed, person());
      ASSERT_GT(layout.obstacles.size(), 4U);
      Crowd crowd(Scene::plaza, agents, seed, person());
      for (int i = 0; i < 3600; ++i) {
        crowd.advance(frame);
        if (i % 5 != 0) continue;
        ASSERT_GT(least_room(crowd, layout), 0.05) << agents << ", seed " << seed << ", frame " << i;
      }
    }
  }
}

TEST(Obstacles, GrowWithTheCharacter) {
  CharacterRoles giant = person();
  giant.height = 18.0;
  giant.walk_speed *= 10.0;
  const CrowdLayout layout = plaza_layout(300, 1, giant);
  Crowd crowd(Scene::plaza, 300, 1, giant);
  for (int i = 0; i < 600; ++i) crowd.advance(frame);
  EXPECT_GT(least_room(crowd, layout), 0.0);
}

TEST(Obstacles, AreWalkedAround) {
  // Somebody walks right across the middle of a fountain, past a lamp, to the other side.
  const std::vector<Obstacle> obstacles{{{0.0, 0.0}, 3.3}, {{0.05, 6.0}, 0.25}};
  Steering steering(
      1, {.lowest = glm::vec2(-10.0F), .highest = glm::vec2(10.0F), .largest_radius = 0.3F, .obstacles = obstacles});
  std::vector<Body> bodies{{.position = {0.0F, -8.0F}, .radius = 0.3F, .agent = 0, .moves = true}};
  std::vector<Wish> wishes(1);
  anim::PuThreads threads(1);
  const glm::vec2 goal(0.0F, 8.0F);
  for (int i = 0; i < 60 * 25; ++i) {
    const glm::vec2 way = goal - bodies[0].position;
    const float left = glm::length(way);
    wishes[0] = {way * (std::min(1.4F, 2.0F * left) / std::max(left, 1e-3F)), 1.4F};
    steering.step(bodies, wishes, 1.0F / 60.0F, threads, 1);
    for (const Obstacle& obstacle : obstacles) {
      ASSERT_GE(glm::distance(glm::dvec2(bodies[0].position), obstacle.position), obstacle.radius + 0.29)
          << "step " << i;
    }
  }
  EXPECT_LT(glm::distance(bodies[0].position, goal), 0.5F);
}

TEST(Obstacles, PeopleSitOnBenches) {
  const CrowdLayout layout = plaza_layout(1000, 1, person());
  const auto seated = std::ranges::count(layout.standers, Habit::rest, &StanderStart::habit);
  EXPECT_GT(seated, 10);
  EXPECT_LT(seated, 150);
  Crowd crowd(Scene::plaza, 1000, 1, person());
  int sit = 0, got_up = 0;
  for (int i = 0; i < 1800; ++i) {
    crowd.advance(frame);
    for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
      if (crowd.minds().habits()[agent] != Habit::rest) continue;
      sit += crowd.minds().roles()[agent] == Role::sit;
      got_up += crowd.minds().roles()[agent] == Role::look_around;
    }
  }
  EXPECT_GT(sit, got_up);
  EXPECT_GT(got_up, 0);
}

}  // namespace
}  // namespace throng::app::obstacles_test
