#include "app/people/crowd/steering/near_bodies.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/random.h"

namespace throng::app::near_bodies_test {
namespace {

using testing::ElementsAreArray;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::uint32_t bodies = 300;

/// Bodies strewn over a square of 12 m, each with a velocity and a size of its own.
BodyColumns strewn_bodies(std::uint32_t seed) {
  Random random(seed, 1);
  BodyColumns columns;
  columns.set_aside(bodies);
  for (std::size_t i = 0; i < bodies; ++i) {
    columns.x[i] = random.between(-6.0F, 6.0F);
    columns.z[i] = random.between(-6.0F, 6.0F);
    columns.velocity_x[i] = random.between(-2.0F, 2.0F);
    columns.velocity_z[i] = random.between(-2.0F, 2.0F);
    columns.radius[i] = random.between(0.2F, 0.4F);
  }
  return columns;
}

bool matters(const NearBodiesJob& job, std::size_t i) {
  const BodyColumns& all = *job.columns;
  const glm::vec2 apart = glm::vec2(all.x[i], all.z[i]) - job.position;
  const float square = glm::dot(apart, apart), sight = job.sight + job.sight_per_radius * all.radius[i];
  if (square > sight * sight) return false;
  const float close = job.close_offset + all.radius[i] + job.close_reach;
  if (square < close * close) return true;
  const glm::vec2 relative = glm::vec2(all.velocity_x[i], all.velocity_z[i]) - job.velocity;
  const float closing = -glm::dot(apart, relative), speed_squared = glm::dot(relative, relative);
  if (closing <= 0.0F || closing >= job.horizon * speed_squared) return false;
  const glm::vec2 miss = apart + relative * (closing / speed_squared);
  const float passing = job.passing_scale * (job.passing_offset + all.radius[i]);
  return glm::dot(miss, miss) < passing * passing;
}

std::vector<std::uint32_t> one_by_one(const NearBodiesJob& job) {
  std::vector<std::uint32_t> places;
  for (const BodyRun& run : job.runs) {
    for (std::uint32_t i = run.first; i < run.end; ++i) {
      if (matters(job, i)) places.push_back(i);
    }
  }
  return places;
}

std::vector<std::uint32_t> found_by(const NearBodiesJob& job) {
  std::vector<std::uint32_t> places;
  NearBodiesCursor cursor;
  NearBodies found;
  bool is_done = false;
  while (!is_done) {
    is_done = find_near_bodies(job, cursor, found);
    EXPECT_LE(found.count, NearBodies::most);
    places.insert(places.end(), found.places.begin(), found.places.begin() + static_cast<std::ptrdiff_t>(found.count));
  }
  return places;
}

class NearBodiesTest : public testing::Test {
 protected:
  NearBodiesJob job_at(glm::vec2 position) const {
    return {.columns = &columns_,
            .runs = runs_,
            .position = position,
            .velocity = {1.2F, 0.4F},
            .sight = 4.0F,
            .passing_scale = 1.5F,
            .passing_offset = 0.3F,
            .close_offset = 0.3F,
            .close_reach = 0.6F,
            .horizon = 2.5F};
  }

  BodyColumns columns_ = strewn_bodies(3);
  std::vector<BodyRun> runs_{{0, 7}, {20, 20}, {31, 100}, {100, 117}, {200, bodies}};
};

TEST_F(NearBodiesTest, AreThoseOfALoopOverAllInItsOrder) {
  Random random(5, 2);
  std::size_t found = 0;
  for (int i = 0; i < 200; ++i) {
    const NearBodiesJob job = job_at({random.between(-5.0F, 5.0F), random.between(-5.0F, 5.0F)});
    const std::vector<std::uint32_t> expected = one_by_one(job);
    EXPECT_THAT(found_by(job), ElementsAreArray(expected));
    found += expected.size();
  }
  EXPECT_GT(found, 1000U) << "some matter";
}

TEST_F(NearBodiesTest, MayBeWideObstaclesThatAreSeenByTheirEdge) {
  NearBodiesJob job = job_at({0.5F, 0.5F});
  std::ranges::fill(columns_.radius, 3.0F);
  job.sight_per_radius = 1.0F;
  job.passing_scale = 1.0F;
  EXPECT_THAT(found_by(job), ElementsAreArray(one_by_one(job)));
}

TEST_F(NearBodiesTest, ComeInSeveralGoesWhereManyMatter) {
  NearBodiesJob job = job_at({0.0F, 0.0F});
  job.sight = job.close_reach = 100.0F;
  runs_ = {{0, bodies}};
  job.runs = runs_;
  EXPECT_THAT(found_by(job), SizeIs(bodies));
}

TEST_F(NearBodiesTest, AreNoneWithoutRunsOrFarAway) {
  NearBodiesJob job = job_at({90.0F, 0.0F});
  EXPECT_THAT(found_by(job), IsEmpty());
  job.runs = {};
  EXPECT_THAT(found_by(job), IsEmpty());
}

TEST_F(NearBodiesTest, AreNotLookedForBeyondTheColumns) {
  NearBodiesJob job = job_at({0.0F, 0.0F});
  EXPECT_TRUE(is_valid(job));
  runs_.push_back({10, bodies + 1});
  job.runs = runs_;
  EXPECT_FALSE(is_valid(job));
  runs_.back() = {11, 10};
  EXPECT_FALSE(is_valid(job));
  job.columns = nullptr;
  EXPECT_FALSE(is_valid(job));
}

}  // namespace
}  // namespace throng::app::near_bodies_test
