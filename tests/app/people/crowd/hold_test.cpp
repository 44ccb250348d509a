#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::hold_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;

bool asks(std::span<const ClipRequest> requests, std::uint32_t agent) {
  return std::ranges::find(requests, agent, &ClipRequest::agent) != requests.end();
}

std::uint32_t first_that_walks(const Crowd& crowd) {
  return static_cast<std::uint32_t>(std::ranges::find(crowd.minds().roles(), Role::walk) -
                                    crowd.minds().roles().begin());
}

TEST(HeldAgent, StaysWhereItIsAndDoesNothing) {
  for (const Scene scene : {Scene::plaza, Scene::parade, Scene::stadium, Scene::grid}) {
    Crowd crowd(scene, 300, 1, person());
    for (std::uint32_t agent = 0; agent < crowd.size(); agent += 7) crowd.hold(agent);
    const std::vector<glm::vec3> before(crowd.positions().begin(), crowd.positions().end());
    for (int i = 0; i < 1200; ++i) {
      const auto requests = crowd.advance(frame);
      for (std::uint32_t agent = 0; agent < crowd.size(); agent += 7) ASSERT_FALSE(asks(requests, agent));
    }
    for (std::uint32_t agent = 0; agent < crowd.size(); agent += 7) {
      EXPECT_EQ(crowd.positions()[agent], before[agent]);
      EXPECT_EQ(crowd.speeds()[agent], 0.0F);
    }
  }
}

TEST(HeldAgent, StopsWalkingAtOnce) {
  Crowd crowd(Scene::plaza, 100, 1, person());
  const std::uint32_t walker = first_that_walks(crowd);
  const auto stops = crowd.hold(walker);
  ASSERT_TRUE(stops);
  EXPECT_EQ(stops->agent, walker);
  EXPECT_EQ(stops->clip, static_cast<int>(index_of(Role::stand)));
  EXPECT_EQ(crowd.minds().roles()[walker], Role::stand);
  EXPECT_FALSE(crowd.hold(walker)) << "it stands already";
}

TEST(HeldAgent, IsInTheWayOfOthers) {
  Crowd crowd(Scene::plaza, 400, 1, person());
  for (std::uint32_t agent = 0; agent < crowd.walkers().count(); agent += 5) crowd.hold(agent);
  for (int i = 0; i < 1200; ++i) {
    crowd.advance(frame);
    for (std::uint32_t held = 0; held < crowd.walkers().count(); held += 5) {
      for (std::uint32_t other = 0; other < crowd.walkers().count(); ++other) {
        if (other == held) continue;
        const float apart = glm::distance(crowd.positions()[held], crowd.positions()[other]);
        ASSERT_GT(apart, 0.8F * (crowd.looks().radii[held] + crowd.looks().radii[other]));
      }
    }
  }
}

TEST(HeldAgent, WalksOnWhenItIsLetGo) {
  Crowd crowd(Scene::plaza, 100, 1, person());
  const std::uint32_t walker = first_that_walks(crowd);
  crowd.hold(walker);
  for (int i = 0; i < 300; ++i) crowd.advance(frame);
  const glm::vec3 lay_at = crowd.positions()[walker];
  EXPECT_TRUE(crowd.release(walker));
  EXPECT_FALSE(crowd.minds().holds(walker));
  float farthest = 0.0F;
  for (int i = 0; i < 3600; ++i) {
    crowd.advance(frame);
    farthest = std::max(farthest, glm::distance(crowd.positions()[walker], lay_at));
  }
  EXPECT_GT(farthest, 2.0F);
}

TEST(HeldAgent, CatchesUpWithItsFileAndNeverJumps) {
  Crowd crowd(Scene::parade, 200, 1, person()), undisturbed(Scene::parade, 200, 1, person());
  const auto marcher = static_cast<std::uint32_t>(crowd.walkers().count());
  crowd.hold(marcher);
  glm::vec3 before = crowd.positions()[marcher];
  for (int i = 0; i < 60 * 60; ++i) {
    if (i == 240) crowd.release(marcher);
    crowd.advance(frame);
    undisturbed.advance(frame);
    EXPECT_LT(glm::distance(crowd.positions()[marcher], before), 2.5F / 60.0F);
    before = crowd.positions()[marcher];
  }
  EXPECT_EQ(crowd.positions()[marcher], undisturbed.positions()[marcher]);
}

}  // namespace
}  // namespace throng::app::hold_test
