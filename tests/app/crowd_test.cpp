#include "app/crowd.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace throng::app {
namespace {

constexpr anim::Ticks frame = anim::ticks_per_second / 60;

CharacterRoles person() {
  CharacterRoles roles;
  roles.clips = {0, 1, 2, 3, no_clip};
  roles.walk_speed = 1.3;
  return roles;
}

bool same_places(const Crowd& a, const Crowd& b) { return std::ranges::equal(a.positions(), b.positions()); }

float least_distance(const Crowd& crowd, std::size_t first, std::size_t last) {
  float least = 1e9F;
  for (std::size_t agent = first; agent < last; ++agent) {
    for (std::size_t other = agent + 1; other < crowd.size(); ++other) {
      least = std::min(least, glm::distance(crowd.positions()[agent], crowd.positions()[other]));
    }
  }
  return least;
}

TEST(Crowd, IsTheSameForTheSameSceneAgentsAndSeed) {
  Crowd one(Scene::plaza, 500, 7, person()), two(Scene::plaza, 500, 7, person());
  for (int i = 0; i < 600; ++i) {
    const auto requests = one.advance(frame), again = two.advance(frame);
    ASSERT_EQ(requests.size(), again.size());
    for (std::size_t request = 0; request < requests.size(); ++request) {
      EXPECT_EQ(requests[request].agent, again[request].agent);
      EXPECT_EQ(requests[request].clip, again[request].clip);
      EXPECT_EQ(requests[request].fade_seconds, again[request].fade_seconds);
    }
  }
  EXPECT_TRUE(same_places(one, two));
  EXPECT_TRUE(std::ranges::equal(one.tints(), two.tints()));
  EXPECT_TRUE(std::ranges::equal(one.start_phases(), two.start_phases()));
}

TEST(Crowd, WalkersStandWhereTheClockSaysHoweverItWasReached) {
  Crowd by_frames(Scene::plaza, 200, 1, person()), at_once(Scene::plaza, 200, 1, person());
  for (int i = 0; i < 600; ++i) by_frames.advance(frame);
  at_once.advance(600 * frame);
  EXPECT_TRUE(same_places(by_frames, at_once));
}

TEST(Crowd, AnotherSeedIsAnotherCrowd) {
  const Crowd one(Scene::plaza, 100, 1, person()), two(Scene::plaza, 100, 2, person());
  EXPECT_FALSE(same_places(one, two));
  EXPECT_FALSE(std::ranges::equal(one.tints(), two.tints()));
  EXPECT_FALSE(std::ranges::equal(one.start_phases(), two.start_phases()));
}

TEST(Crowd, StandersKeepTheirDistance) {
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const Crowd crowd(Scene::plaza, 5000, seed, person());
    EXPECT_GE(least_distance(crowd, crowd.walkers(), crowd.size()), 0.7F);
  }
}

TEST(Crowd, SomeRestAndSomeActFromTheStart) {
  for (const Scene scene : {Scene::plaza, Scene::grid}) {
    const Crowd crowd(scene, 300, 1, person());
    const auto standing = crowd.roles().subspan(crowd.walkers());
    const auto resting = static_cast<std::size_t>(std::ranges::count(standing, Role::idle));
    EXPECT_GT(resting, standing.size() / 2);
    EXPECT_LT(resting, standing.size() * 9 / 10);
  }
}

TEST(Crowd, NobodyEverRunsIntoAnother) {
  Crowd crowd(Scene::plaza, 400, 3, person());
  ASSERT_GT(crowd.walkers(), 100U);
  for (int half_second = 0; half_second < 120; ++half_second) {
    ASSERT_GE(least_distance(crowd, 0, crowd.walkers()), 0.89F) << half_second / 2 << " s";
    crowd.advance(30 * frame);
  }
}

TEST(Crowd, FeetDoNotSlide) {
  Crowd crowd(Scene::plaza, 1000, 1, person());
  std::vector<glm::vec3> before(crowd.positions().begin(), crowd.positions().end());
  for (int i = 0; i < 300; ++i) {
    crowd.advance(frame);
    for (std::size_t walker = 0; walker < crowd.walkers(); ++walker) {
      const double expected = 1.3 * static_cast<double>(crowd.scales()[walker]) *
                              static_cast<double>(crowd.playback_speeds()[walker]) / 60.0;
      const glm::vec3 step = crowd.positions()[walker] - before[walker];
      ASSERT_NEAR(static_cast<double>(glm::length(step)), expected, 1e-5);
      const Heading heading = crowd.headings()[walker];
      ASSERT_GT(step.x * heading.sine + step.z * heading.cosine, 0.999F * glm::length(step));
    }
    std::ranges::copy(crowd.positions(), before.begin());
  }
}

TEST(Crowd, OnlyWalkersMove) {
  Crowd crowd(Scene::plaza, 300, 1, person());
  const std::vector<glm::vec3> before(crowd.positions().begin(), crowd.positions().end());
  crowd.advance(frame);
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    EXPECT_EQ(crowd.positions()[agent] != before[agent], agent < crowd.walkers());
    EXPECT_EQ(crowd.roles()[agent] == Role::walk, agent < crowd.walkers());
  }
}

TEST(Crowd, LanesAreClosed) {
  const Crowd crowd(Scene::plaza, 1000, 1, person());
  ASSERT_GT(crowd.lanes().size(), 3U);
  std::set<double> directions;
  for (const Lane& lane : crowd.lanes()) {
    const double length = lane.length();
    directions.insert(lane.direction);
    for (int part = 0; part < 20; ++part) {
      const LanePlace place = lane.at(length * part / 20.0);
      EXPECT_LT(glm::distance(place.position, lane.at(length * (part + 20) / 20.0).position), 1e-9);
      EXPECT_NEAR(lane.signed_distance(place.position), 0.0, 1e-9);
    }
    const glm::dvec2 just_before_the_end = lane.at(length - 1e-3).position;
    EXPECT_NEAR(glm::distance(just_before_the_end, lane.at(0.0).position), 1e-3, 1e-5);
  }
  EXPECT_EQ(directions, (std::set<double>{-1.0, 1.0}));
}

TEST(Crowd, EveryoneStaysWithinTheRangesOfLooksAndPace) {
  const Crowd crowd(Scene::plaza, 2000, 1, person());
  std::set<Tints> looks(crowd.tints().begin(), crowd.tints().end());
  EXPECT_GT(looks.size(), 1900U);
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    EXPECT_GE(crowd.scales()[agent], 0.9F);
    EXPECT_LE(crowd.scales()[agent], 1.08F);
    EXPECT_GE(crowd.playback_speeds()[agent], 0.8999F);
    EXPECT_LE(crowd.playback_speeds()[agent], 1.1001F);
    EXPECT_LT(crowd.start_phases()[agent], 1.0F);
    const Heading heading = crowd.headings()[agent];
    EXPECT_NEAR(heading.cosine * heading.cosine + heading.sine * heading.sine, 1.0F, 1e-5F);
    for (const std::uint32_t tint : crowd.tints()[agent]) EXPECT_EQ(tint >> 24U, 0xFFU);
  }
}

TEST(Crowd, EveryRequestNamesAClipThatTheCharacterHasAndIsNotPlayingAlready) {
  Crowd crowd(Scene::plaza, 500, 1, person());
  std::vector<int> clips(crowd.clips().begin(), crowd.clips().end());
  std::set<Role> asked;
  for (int i = 0; i < 60 * 30; ++i) {
    for (const ClipRequest& request : crowd.advance(frame)) {
      ASSERT_GE(request.agent, crowd.walkers());
      EXPECT_EQ(request.clip, person().clip(request.role));
      EXPECT_NE(request.clip, no_clip);
      EXPECT_NE(request.clip, clips[request.agent]);
      EXPECT_GE(request.fade_seconds, 0.3F);
      EXPECT_LE(request.fade_seconds, 0.8F);
      clips[request.agent] = request.clip;
      asked.insert(request.role);
    }
  }
  EXPECT_TRUE(std::ranges::equal(crowd.clips(), clips));
  EXPECT_EQ(asked, (std::set<Role>{Role::idle, Role::cheer, Role::wave}));
}

TEST(Crowd, WithoutAWalkNobodyWalks) {
  CharacterRoles statue = person();
  statue.clips[static_cast<std::size_t>(Role::walk)] = no_clip;
  EXPECT_EQ(Crowd(Scene::plaza, 100, 1, statue).walkers(), 0U);
  CharacterRoles treadmill = person();
  treadmill.walk_speed = 0.0;
  EXPECT_EQ(Crowd(Scene::plaza, 100, 1, treadmill).walkers(), 0U);
}

TEST(Crowd, WithoutAnIdleStandersTakeTurnsInWhatThereIs) {
  CharacterRoles roles;
  roles.others = {4, 7, 9};
  Crowd crowd(Scene::plaza, 30, 1, roles);
  EXPECT_EQ(std::set<int>(crowd.clips().begin(), crowd.clips().end()), (std::set<int>{4, 7, 9}));
  std::size_t requests = 0;
  for (int i = 0; i < 60 * 20; ++i) {
    for (const ClipRequest& request : crowd.advance(frame)) {
      EXPECT_EQ(request.role, Role::other);
      EXPECT_TRUE(request.clip == 4 || request.clip == 7 || request.clip == 9);
      ++requests;
    }
  }
  EXPECT_GE(requests, 30U);
}

TEST(Crowd, WithOneClipOrNoneNothingIsAsked) {
  CharacterRoles lone;
  lone.others = {0};
  Crowd one(Scene::plaza, 20, 1, lone), none(Scene::plaza, 20, 1, CharacterRoles{});
  EXPECT_EQ(one.clips()[5], 0);
  EXPECT_EQ(none.clips()[5], no_clip);
  for (int i = 0; i < 60 * 20; ++i) {
    EXPECT_TRUE(one.advance(frame).empty());
    EXPECT_TRUE(none.advance(frame).empty());
  }
}

TEST(Crowd, ALargerCharacterTakesMoreRoom) {
  CharacterRoles giant = person();
  giant.height = 18.0;
  const Crowd crowd(Scene::plaza, 100, 1, giant);
  EXPECT_GE(least_distance(crowd, crowd.walkers(), crowd.size()), 7.0F);
}

TEST(Crowd, AnyNumberFindsItsPlace) {
  for (const std::size_t agents : {1U, 2U, 3U, 10U, 47U, 300U, 100'000U}) {
    Crowd crowd(Scene::plaza, agents, 1, person());
    EXPECT_EQ(crowd.size(), agents);
    crowd.advance(frame);
    const auto reach = static_cast<float>(plaza_side(agents, 1.0));
    for (const glm::vec3& position : crowd.positions()) {
      ASSERT_LT(std::max(std::abs(position.x), std::abs(position.z)), 0.6F * reach + 4.0F);
    }
  }
}

TEST(Crowd, TheGridStandsInRowsThatFaceForward) {
  const Crowd crowd(Scene::grid, 17, 1, person());
  EXPECT_EQ(crowd.walkers(), 0U);
  EXPECT_EQ(crowd.positions()[0], glm::vec3(-3.0F, 0.0F, 0.0F));
  EXPECT_EQ(crowd.positions()[4], glm::vec3(3.0F, 0.0F, 0.0F));
  EXPECT_EQ(crowd.positions()[16], glm::vec3(-1.5F, 0.0F, -4.5F));
  for (const Heading& heading : crowd.headings()) {
    EXPECT_EQ(heading.cosine, 1.0F);
    EXPECT_EQ(heading.sine, 0.0F);
  }
}

TEST(Crowd, AdvancingByNothingChangesNothing) {
  Crowd crowd(Scene::plaza, 100, 1, person());
  const std::vector<glm::vec3> before(crowd.positions().begin(), crowd.positions().end());
  EXPECT_TRUE(crowd.advance(0).empty());
  EXPECT_TRUE(std::ranges::equal(crowd.positions(), before));
}

}  // namespace
}  // namespace throng::app
