#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "app/people/crowd/parade.h"
#include "engine/anim/run/pu_threads.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::scenes_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;

glm::vec2 on_ground(const glm::vec3& position) { return {position.x, position.z}; }

bool is_finite(const Crowd& crowd, std::size_t agent) {
  const glm::vec3 position = crowd.positions()[agent];
  const Heading heading = crowd.headings()[agent];
  return std::isfinite(position.x + position.y + position.z) && std::isfinite(heading.cosine + heading.sine) &&
         std::isfinite(crowd.playback_speeds()[agent]);
}

/// The least distance of two agents, as a share of their radii summed.
float least_share_of_radii_between(const Crowd& crowd) {
  float least = 1e9F;
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    const glm::vec2 here = on_ground(crowd.positions()[agent]);
    for (std::size_t other = agent + 1; other < crowd.size(); ++other) {
      const glm::vec2 apart = on_ground(crowd.positions()[other]) - here;
      const float radii = crowd.looks().radii[agent] + crowd.looks().radii[other];
      least = std::min(least, glm::dot(apart, apart) / (radii * radii));
    }
  }
  return std::sqrt(least);
}

class EveryScene : public testing::TestWithParam<Scene> {};

TEST_P(EveryScene, KeepsFiveHundredApartForAMinute) {
  Crowd crowd(GetParam(), 500, 1, person());
  for (int i = 0; i < 3600; ++i) {
    crowd.advance(frame);
    ASSERT_GE(least_share_of_radii_between(crowd), 0.8F) << "frame " << i;
  }
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) ASSERT_TRUE(is_finite(crowd, agent)) << agent;
}

TEST_P(EveryScene, IsTheSameToTheLastBitForAnyNumberOfJobs) {
  anim::PuThreads two(2), five(5);
  Crowd alone(GetParam(), 500, 1, person()), by_two(GetParam(), 500, 1, person()),
      by_five(GetParam(), 500, 1, person());
  for (int i = 0; i < 300; ++i) {
    alone.advance(frame);
    by_two.advance(frame, two, 2);
    by_five.advance(frame, five, 5);
  }
  EXPECT_TRUE(std::ranges::equal(alone.positions(), by_two.positions()));
  EXPECT_TRUE(std::ranges::equal(alone.positions(), by_five.positions()));
  EXPECT_TRUE(std::ranges::equal(alone.playback_speeds(), by_five.playback_speeds()));
  EXPECT_TRUE(std::ranges::equal(alone.minds().clips(), by_five.minds().clips()));
}

TEST_P(EveryScene, TakesAnyNumberAnyStepAndAnyCharacter) {
  CharacterRoles giant = person();
  giant.height = 18.0;
  giant.radius = 6.0;
  for (const CharacterRoles& character : {person(), giant, character_with({Role::walk}), CharacterRoles{}}) {
    for (const std::size_t agents : {1U, 2U, 3U, 17U, 100U}) {
      Crowd crowd(GetParam(), agents, 1, character);
      ASSERT_EQ(crowd.size(), agents);
      for (const Ticks dt : {frame, Ticks{0}, Ticks{1}, 600 * frame, frame}) crowd.advance(dt);
      for (std::size_t agent = 0; agent < agents; ++agent) ASSERT_TRUE(is_finite(crowd, agent));
      EXPECT_GE(least_share_of_radii_between(crowd), 0.8F) << agents;
    }
  }
}

std::string name_of(const testing::TestParamInfo<Scene>& tested) {
  constexpr const char* names[] = {"Plaza", "Parade", "Stadium", "Grid"};
  return names[static_cast<int>(tested.param)];
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::Values(Scene::plaza, Scene::parade, Scene::stadium, Scene::grid),
                         name_of);

TEST(Plaza, PeopleWalkStopLookAroundWaveAndRun) {
  Crowd crowd(Scene::plaza, 500, 1, person());
  std::set<Role> walkers_did;
  for (int i = 0; i < 60 * 40; ++i) {
    for (const ClipRequest& request : crowd.advance(frame)) {
      if (request.agent < crowd.walkers().count()) walkers_did.insert(request.role);
    }
  }
  EXPECT_EQ(walkers_did,
            (std::set<Role>{Role::stand, Role::look_around, Role::walk, Role::jog, Role::run, Role::wave}));
}

TEST(Plaza, HardlyAnybodyIsHemmedIn) {
  Crowd crowd(Scene::plaza, 1000, 1, person());
  for (int i = 0; i < 60 * 60; ++i) crowd.advance(frame);
  std::vector<float> walked(crowd.walkers().count(), 0.0F);
  for (int i = 0; i < 60 * 60; ++i) {
    crowd.advance(frame);
    for (std::size_t walker = 0; walker < walked.size(); ++walker) walked[walker] += crowd.speeds()[walker] / 60.0F;
  }
  std::ranges::sort(walked);
  EXPECT_GT(walked[walked.size() / 100], 20.0F) << "metres in a minute, of all but one in a hundred";
  EXPECT_GT(walked[walked.size() / 2], 45.0F);
}

TEST(Parade, RanksStayInStepOnTheStraights) {
  const CharacterRoles marcher = person();
  Crowd crowd(Scene::parade, 500, 1, marcher);
  ASSERT_GT(crowd.marchers().count(), 250U);
  std::vector<double> phases(crowd.looks().start_phases.begin(), crowd.looks().start_phases.end());
  const ParadeSize size = parade_size(500, marcher);
  for (int i = 0; i < 3600; ++i) {
    crowd.advance(frame);
    for (std::size_t agent = crowd.walkers().count(); agent < crowd.marchers().count(); ++agent) {
      phases[agent] += static_cast<double>(crowd.playback_speeds()[agent]) / 60.0 / marcher.walk_seconds;
    }
  }
  double widest = 0.0;
  int compared = 0;
  for (std::size_t agent = 0; agent + 1 < crowd.marchers().count(); ++agent) {
    const glm::vec3 here = crowd.positions()[agent], beside = crowd.positions()[agent + 1];
    const bool same_rank = std::abs(here.x - beside.x) < 0.1F && glm::distance(here, beside) < 2.0F;
    if (!same_rank || std::abs(static_cast<double>(here.x)) > size.half_length - 1.0) continue;
    const double apart = phases[agent] - phases[agent + 1];
    widest = std::max(widest, std::abs(apart - std::round(apart)));
    ++compared;
  }
  EXPECT_GT(compared, 50);
  EXPECT_LT(widest, 0.08) << "of a cycle, after a minute and several turns";
}

TEST(Parade, SpectatorsLineTheRouteAndFaceIt) {
  const Crowd crowd(Scene::parade, 500, 1, person());
  for (std::size_t agent = crowd.marchers().count(); agent < crowd.size(); ++agent) {
    EXPECT_EQ(crowd.minds().habits()[agent], Habit::watch);
    const glm::vec3 position = crowd.positions()[agent];
    const Heading heading = crowd.headings()[agent];
    const Lane route{{0.0, 0.0}, {parade_size(500, person()).half_length, 0.0}, parade_size(500, person()).radius};
    const double before = std::abs(route.signed_distance({position.x, position.z}));
    const double nearer = std::abs(route.signed_distance({position.x + heading.sine, position.z + heading.cosine}));
    EXPECT_NEAR(before - nearer, 1.0, 1e-3);
  }
}

TEST(Stadium, TheWaveRunsRound) {
  Crowd crowd(Scene::stadium, 500, 1, person());
  const auto angle_of_the_cheering = [&] {  // of their middle, seen from the field
    glm::vec2 middle(0.0F);
    for (std::size_t agent = crowd.walkers().count(); agent < crowd.size(); ++agent) {
      if (crowd.minds().roles()[agent] == Role::cheer) middle += glm::normalize(on_ground(crowd.positions()[agent]));
    }
    return std::atan2(middle.y, middle.x);
  };
  for (int i = 0; i < 60 * 12; ++i) crowd.advance(frame);
  float turned = 0.0F, before = angle_of_the_cheering();
  for (int second = 0; second < 9; ++second) {
    for (int i = 0; i < 60; ++i) crowd.advance(frame);
    const float now = angle_of_the_cheering();
    turned += std::remainder(now - before, 6.2831853F);
    before = now;
  }
  EXPECT_NEAR(turned, 6.28F, 1.2F) << "once round in nine seconds";
}

TEST(Stadium, SeatsFaceTheField) {
  const Crowd crowd(Scene::stadium, 500, 1, person());
  for (std::size_t agent = crowd.walkers().count(); agent < crowd.size(); ++agent) {
    const Heading heading = crowd.headings()[agent];
    EXPECT_LT(glm::dot(on_ground(crowd.positions()[agent]), glm::vec2(heading.sine, heading.cosine)), 0.0F);
  }
}

}  // namespace
}  // namespace throng::app::scenes_test
