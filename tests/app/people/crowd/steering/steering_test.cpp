#include "app/people/crowd/steering/steering.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/run/pu_threads.h"
#include "engine/base/random.h"

namespace throng::app::steering_test {
namespace {

constexpr float radius = 0.3F;
constexpr float frame = 1.0F / 60.0F;
constexpr float walking = 1.4F;

/// Agents that walk to a goal each and stop there.
struct Walk {
  struct Start {
    glm::vec2 position, goal;
  };

  explicit Walk(const std::vector<Start>& starts, int jobs_at_once = 1)
      : steering(starts.size(), {.lowest = glm::vec2(-20.0F), .highest = glm::vec2(20.0F), .largest_radius = radius}),
        wishes(starts.size()),
        threads(jobs_at_once),
        jobs(jobs_at_once) {
    for (const Start& start : starts) {
      goals.push_back(start.goal);
      bodies.push_back({.position = start.position,
                        .velocity = {},
                        .radius = radius,
                        .agent = static_cast<std::uint32_t>(bodies.size()),
                        .moves = true});
    }
  }

  void step() {
    for (std::size_t agent = 0; agent < bodies.size(); ++agent) {
      const glm::vec2 way = goals[agent] - bodies[agent].position;
      const float left = glm::length(way);
      wishes[agent] = {left > 0.05F ? way * (std::min(walking, 2.0F * left) / left) : glm::vec2(0.0F), walking};
    }
    steering.step(bodies, wishes, frame, threads, jobs);
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) {
      step();
      nearest = std::min(nearest, least_distance());
    }
  }
  float least_distance() const {
    float least = 1e9F;
    for (std::size_t agent = 0; agent < bodies.size(); ++agent) {
      for (std::size_t other = agent + 1; other < bodies.size(); ++other) {
        least = std::min(least, glm::distance(bodies[agent].position, bodies[other].position));
      }
    }
    return least;
  }
  std::size_t arrived() const {
    std::size_t count = 0;
    for (const Body& body : bodies) count += glm::distance(body.position, goals[body.agent]) < 0.3F ? 1U : 0U;
    return count;
  }

  Steering steering;
  std::vector<Body> bodies;
  std::vector<Wish> wishes;
  std::vector<glm::vec2> goals;
  anim::PuThreads threads;
  int jobs;
  float nearest = 1e9F;
};

constexpr float least_allowed = 0.8F * 2.0F * radius;

TEST(Steering, SomeoneAloneWalksStraight) {
  Walk walk({{{-5, 0}, {5, 0}}});
  walk.run(600);
  EXPECT_EQ(walk.arrived(), 1U);
  EXPECT_EQ(walk.bodies[0].position.y, 0.0F);
}

TEST(Steering, TwoHeadOnPassOnTheRightWithoutSlowingMuch) {
  Walk walk({{{-5, 0}, {5, 0}}, {{5, 0}, {-5, 0}}});
  float aside = 0.0F;
  for (int i = 0; i < 540; ++i) {  // 10 m at 1.4 m/s are 430 frames
    walk.run(1);
    aside = std::max(aside, walk.bodies[0].position.y);
  }
  EXPECT_EQ(walk.arrived(), 2U);
  EXPECT_GE(walk.nearest, 2.0F * radius) << "they do not even touch";
  EXPECT_GT(aside, radius) << "who walks along +x has +z on its right";
}

TEST(Steering, FourCrossAndAllArrive) {
  Walk walk({{{-6, 0}, {6, 0}}, {{6, 0}, {-6, 0}}, {{0, -6}, {0, 6}}, {{0, 6}, {0, -6}}});
  walk.run(900);
  EXPECT_EQ(walk.arrived(), 4U);
  EXPECT_GE(walk.nearest, least_allowed);
}

TEST(Steering, WalksAroundThoseWhoStand) {
  Walk walk({{{-5, 0}, {5, 0}}, {{0, 0}, {0, 0}}, {{1, 0.6F}, {1, 0.6F}}});
  walk.bodies[1].moves = walk.bodies[2].moves = false;
  walk.run(700);
  EXPECT_EQ(walk.arrived(), 3U);
  EXPECT_EQ(walk.bodies[1].position, glm::vec2(0.0F));
  EXPECT_GE(walk.nearest, least_allowed);
}

TEST(Steering, ABlockWalksThroughABlock) {
  std::vector<Walk::Start> starts;
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 5; ++column) {
      const glm::vec2 place(-10.0F + 0.9F * static_cast<float>(column), 0.9F * static_cast<float>(row - 5));
      starts.push_back({place, place + glm::vec2(16.0F, 0.0F)});
      starts.push_back({{-place.x, place.y + 0.3F}, {-place.x - 16.0F, place.y + 0.3F}});
    }
  }
  Walk walk(starts);
  walk.run(1500);
  EXPECT_GE(walk.nearest, least_allowed);
  for (const Body& body : walk.bodies) {
    EXPECT_GT(body.position.x * (walk.goals[body.agent].x > 0.0F ? 1.0F : -1.0F), 3.0F) << "through and beyond";
  }
}

TEST(Steering, AThrongThatAllWantsToTheSamePlaceKeepsApart) {
  Random random(3, 1);
  std::vector<Walk::Start> starts;
  for (int i = 0; i < 300; ++i) {
    starts.push_back({{0.8F * static_cast<float>(i % 20) - 8.0F, 0.8F * static_cast<float>(i / 20) - 6.0F},
                      {random.between(-0.5F, 0.5F), random.between(-0.5F, 0.5F)}});
  }
  Walk walk(starts);
  walk.run(300);
  EXPECT_GE(walk.nearest, least_allowed);
}

TEST(Steering, SpeedsUpAndSlowsDownWithinLimits) {
  Walk walk({{{-5, 0}, {5, 0}}, {{5, 0.1F}, {-5, 0.1F}}, {{0, -5}, {0, 5}}});
  std::vector<Body> before = walk.bodies;
  for (int i = 0; i < 600; ++i) {
    walk.step();
    for (std::size_t agent = 0; agent < before.size(); ++agent) {
      ASSERT_LE(glm::distance(walk.bodies[agent].velocity, before[agent].velocity), 7.01F * frame) << "frame " << i;
    }
    before = walk.bodies;
  }
}

TEST(Steering, IsTheSameToTheLastBitForAnyNumberOfJobs) {
  Random random(5, 2);
  std::vector<Walk::Start> starts;
  for (int i = 0; i < 900; ++i) {
    starts.push_back({{static_cast<float>(i % 30) - 15.0F, static_cast<float>(i / 30) - 15.0F},
                      {random.between(-15.0F, 15.0F), random.between(-15.0F, 15.0F)}});
  }
  Walk one(starts, 1), two(starts, 2), five(starts, 5);
  for (int i = 0; i < 120; ++i) {
    one.step();
    two.step();
    five.step();
  }
  for (std::size_t agent = 0; agent < starts.size(); ++agent) {
    ASSERT_EQ(one.bodies[agent].position, two.bodies[agent].position);
    ASSERT_EQ(one.bodies[agent].position, five.bodies[agent].position);
    ASSERT_EQ(one.bodies[agent].velocity, five.bodies[agent].velocity);
  }
  EXPECT_GE(five.least_distance(), least_allowed);
}

TEST(Steering, HoldsForLongStepsToo) {
  Walk walk({{{-5, 0}, {5, 0}}, {{5, 0.01F}, {-5, 0}}});
  for (std::size_t agent = 0; agent < 2; ++agent) walk.wishes[agent] = {-0.3F * walk.bodies[agent].position, 100.0F};
  for (int i = 0; i < 10; ++i) {
    walk.steering.step(walk.bodies, walk.wishes, 2.0F, walk.threads, 1);
    EXPECT_GE(walk.least_distance(), least_allowed);
  }
}

TEST(CrowdCells, FindEveryoneInReachInTheSameOrderAlsoBeyondTheEdge) {
  Random random(1, 1);
  std::vector<Body> bodies;
  for (std::uint32_t agent = 0; agent < 500; ++agent) {
    bodies.push_back({.position = {random.between(-15.0F, 15.0F), random.between(-15.0F, 15.0F)}, .agent = agent});
  }
  CrowdCells cells;
  cells.set_aside(bodies.size(), glm::vec2(-10.0F), glm::vec2(10.0F), 3.0F);
  cells.sort(bodies);
  for (const Body& self : bodies) {
    std::vector<std::uint32_t> expected, found;
    for (const Body& other : bodies) {
      if (glm::distance(self.position, other.position) <= 3.0F) expected.push_back(other.agent);
    }
    cells.visit_near(self.position, [&](const Body& other) {
      if (glm::distance(self.position, other.position) <= 3.0F) found.push_back(other.agent);
    });
    std::ranges::sort(found);
    ASSERT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace throng::app::steering_test
