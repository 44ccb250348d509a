#include "app/people/crowd/formation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "app/people/crowd/plaza_plan.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::formation_test {
namespace {

TEST(Formation, HoldsEverybodyCloseTogetherAndNobodyTooClose) {
  for (const std::size_t people : {1U, 2U, 50U, 3000U}) {
    const CrowdLayout layout = plaza_layout(people, 1, person(), Clothes::pattern);
    ASSERT_EQ(layout.standers.size(), people) << "nobody walks out of a picture";
    const double edge = plaza_edge(people, 1.0, Clothes::pattern);
    for (std::size_t i = 0; i < people; ++i) {
      const glm::dvec2 here = layout.standers[i].position;
      EXPECT_LT(std::max(std::abs(here.x), std::abs(here.y)), edge);
      double nearest = 1e9;
      for (std::size_t other = 0; other < people; ++other) {
        if (other != i) nearest = std::min(nearest, glm::distance(here, layout.standers[other].position));
      }
      EXPECT_GT(nearest, 0.6);
      EXPECT_LT(nearest, people >= 50 ? 2.0 : 1e10);
      for (const Obstacle& obstacle : layout.obstacles) {
        EXPECT_GT(glm::distance(obstacle.position, here), obstacle.radius + 0.3);
      }
    }
  }
}

TEST(Formation, LooksToWhereThePictureIsTaken) {
  const CrowdLayout layout = plaza_layout(1000, 1, person(), Clothes::pattern);
  const glm::dvec2 viewpoint = plaza_viewpoint(1000, 1.0, Clothes::pattern);
  for (const StanderStart& stander : layout.standers) {
    const glm::dvec2 way = viewpoint - stander.position;
    if (glm::length(way) < 1.0) continue;
    EXPECT_GT(glm::dot(forward_of(stander.heading), glm::normalize(way)), 0.95);
  }
}

TEST(Formation, HasNothingTallBetweenItsPeople) {
  for (const std::size_t people : {1000U, 50'000U}) {
    const double half = 0.5 * plaza_side(people, 1.0, Clothes::pattern);
    for (const Fixture& fixture : plan_plaza(people, 1, person(), Clothes::pattern).fixtures) {
      if (fixture.kind == FixtureKind::fountain || fixture.kind == FixtureKind::bench) continue;
      EXPECT_GT(std::max(std::abs(fixture.position.x), std::abs(fixture.position.y)), half) << people;
    }
  }
}

TEST(Formation, IsTheSameForTheSameSeed) {
  const CrowdLayout once = plaza_layout(500, 3, person(), Clothes::pattern),
                    again = plaza_layout(500, 3, person(), Clothes::pattern);
  for (std::size_t i = 0; i < once.standers.size(); ++i) {
    EXPECT_EQ(once.standers[i].position, again.standers[i].position);
  }
}

}  // namespace
}  // namespace throng::app::formation_test
