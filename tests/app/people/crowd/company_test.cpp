#include "app/people/crowd/company.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "engine/base/tiles.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::company_test {
namespace {

constexpr Ticks frame = ticks_per_second / 30;

/// Runs the last job first.
class Backwards final : public Executor {
 public:
  void run(int count, Job job) override {
    for (int index = count; index-- > 0;) job.run(job.context, index);
  }
};

/// A plaza with bodies of several kinds, and hence with company.
class CompanyOfAPlaza : public testing::Test {
 protected:
  static CharacterRoles person_with_children() {
    CharacterRoles roles = person();
    roles.bodies = {{.share = 5, .size = 1.0}, {.share = 1, .size = 0.66}};
    return roles;
  }

  std::vector<std::size_t> followers() const {
    std::vector<std::size_t> all;
    for (std::size_t walker = 0; walker < crowd_.walkers().count(); ++walker) {
      if (crowd_.minds().habits()[walker] == Habit::accompany) all.push_back(walker);
    }
    return all;
  }
  /// Leaders come right before their company.
  std::size_t leader_of(std::size_t follower) const {
    while (crowd_.minds().habits()[follower] == Habit::accompany) --follower;
    return follower;
  }
  float distance_to_leader(std::size_t follower) const {
    return glm::distance(crowd_.positions()[follower], crowd_.positions()[leader_of(follower)]);
  }

  CharacterRoles roles_ = person_with_children();
  Crowd crowd_{Scene::plaza, 800, 3, std::span(&roles_, 1), {.bodies = true}};
};

TEST_F(CompanyOfAPlaza, WalksBesideItsLeader) {
  ASSERT_GT(followers().size(), crowd_.walkers().count() / 6);
  std::size_t looks = 0, beside = 0;
  for (int i = 0; i < 60 * 30; ++i) {
    crowd_.advance(frame);
    if (i % 30 != 0) continue;
    for (const std::size_t follower : followers()) {
      ++looks;
      beside += distance_to_leader(follower) < 1.6F ? 1U : 0U;
    }
  }
  EXPECT_GT(static_cast<double>(beside), 0.93 * static_cast<double>(looks));
}

// Leaders decide before those beside them, also where a tile ends between the two and comes last.
TEST_F(CompanyOfAPlaza, GoesTheSameWayWhicheverTileComesFirst) {
  int compared = 0;
  for (std::uint32_t seed = 1; seed < 100 && compared < 4; ++seed) {
    Crowd one(Scene::plaza, 400, seed, std::span(&roles_, 1), {.bodies = true});
    const bool is_cut =
        one.walkers().count() > SharedTiles::tile && one.minds().habits()[SharedTiles::tile] == Habit::accompany;
    if (!is_cut) continue;
    ++compared;
    Crowd other(Scene::plaza, 400, seed, std::span(&roles_, 1), {.bodies = true});
    Backwards backwards;
    for (int i = 0; i < 60 * 30; ++i) {
      one.advance(frame);
      other.advance(frame, backwards, 2);
    }
    EXPECT_TRUE(std::ranges::equal(one.positions(), other.positions())) << "seed " << seed;
  }
  EXPECT_EQ(compared, 4);
}

TEST_F(CompanyOfAPlaza, KeepsItsSide) {
  std::size_t looks = 0, across = 0;
  for (int i = 0; i < 60 * 30; ++i) {
    crowd_.advance(frame);
    if (i % 15 != 0) continue;
    for (const std::size_t follower : followers()) {
      const std::size_t leader = leader_of(follower);
      if (follower != leader + 1) continue;  // the first is on the left
      const glm::vec3 way = crowd_.positions()[follower] - crowd_.positions()[leader];
      const Heading heading = crowd_.headings()[leader];
      ++looks;
      across += way.x * heading.cosine - way.z * heading.sine < -0.1F ? 1U : 0U;
    }
  }
  ASSERT_GT(looks, 1000U);
  EXPECT_LT(static_cast<double>(across), 0.06 * static_cast<double>(looks)) << "children would have to let go";
}

TEST_F(CompanyOfAPlaza, StopsWhenItsLeaderDoes) {
  std::size_t looks = 0, stand = 0;
  std::vector<int> stood(crowd_.size(), 0);
  for (int i = 0; i < 40 * 30; ++i) {
    crowd_.advance(frame);
    for (const std::size_t follower : followers()) {
      const std::size_t leader = leader_of(follower);
      stood[leader] = crowd_.speeds()[leader] < 0.05F ? stood[leader] + 1 : 0;
      if (stood[leader] < 60) continue;  // two seconds
      ++looks;
      stand += crowd_.speeds()[follower] < 0.1F ? 1U : 0U;
    }
  }
  ASSERT_GT(looks, 200U);
  EXPECT_GT(static_cast<double>(stand), 0.9 * static_cast<double>(looks));
}

TEST_F(CompanyOfAPlaza, HasChildrenBesideGrownUpsAlone) {
  std::size_t children = 0;
  for (std::size_t agent = 0; agent < crowd_.size(); ++agent) {
    if (crowd_.looks().bodies[agent] != 1) continue;
    ++children;
    ASSERT_GT(agent, 0U);
    if (agent < crowd_.walkers().count()) {
      EXPECT_EQ(crowd_.minds().habits()[agent], Habit::accompany);
    }
    EXPECT_EQ(crowd_.looks().bodies[agent - 1], 0) << "a grown-up stands or walks beside it";
    EXPECT_LT(glm::distance(crowd_.positions()[agent], crowd_.positions()[agent - 1]), 2.5F);
  }
  EXPECT_GT(children, crowd_.size() / 25);
}

TEST_F(CompanyOfAPlaza, MeetsNobody) {
  for (int i = 0; i < 20 * 30; ++i) {
    crowd_.advance(frame);
    if (i % 60 != 0) continue;
    for (const std::size_t follower : followers()) {
      const std::size_t leader = leader_of(follower);
      const float radii = crowd_.looks().radii[follower] + crowd_.looks().radii[leader];
      EXPECT_GT(distance_to_leader(follower), 0.8F * radii);
    }
  }
}

TEST(Company, IsKeptByNobodyWhereThereAreNoBodies) {
  const Crowd crowd(Scene::plaza, 300, 1, person());
  EXPECT_EQ(std::ranges::count(crowd.minds().habits(), Habit::accompany), 0);
}

}  // namespace
}  // namespace throng::app::company_test
