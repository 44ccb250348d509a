#include "app/people/crowd/crowd.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::crowd_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;

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
  EXPECT_TRUE(std::ranges::equal(one.looks().tints, two.looks().tints));
  EXPECT_TRUE(std::ranges::equal(one.looks().start_phases, two.looks().start_phases));
}

TEST(Crowd, MarchersAreWhereTheClockSaysHoweverItWasReached) {
  Crowd by_frames(Scene::parade, 200, 1, person()), at_once(Scene::parade, 200, 1, person());
  for (int i = 0; i < 600; ++i) by_frames.advance(frame);
  at_once.advance(600 * frame);
  EXPECT_TRUE(same_places(by_frames, at_once));
}

TEST(Crowd, AnotherSeedIsAnotherCrowd) {
  const Crowd one(Scene::plaza, 100, 1, person()), two(Scene::plaza, 100, 2, person());
  EXPECT_FALSE(same_places(one, two));
  EXPECT_FALSE(std::ranges::equal(one.looks().tints, two.looks().tints));
  EXPECT_FALSE(std::ranges::equal(one.looks().start_phases, two.looks().start_phases));
}

TEST(Crowd, StandersKeepTheirDistance) {
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const Crowd crowd(Scene::plaza, 5000, seed, person());
    EXPECT_GE(least_distance(crowd, crowd.walkers().count(), crowd.size()), 0.7F);
  }
}

TEST(Crowd, SomeRestAndSomeActFromTheStart) {
  for (const Scene scene : {Scene::plaza, Scene::grid}) {
    const Crowd crowd(scene, 300, 1, person());
    const auto standing = crowd.minds().roles().subspan(crowd.walkers().count());
    const auto resting = static_cast<std::size_t>(std::ranges::count(standing, Role::stand));
    EXPECT_GT(resting, standing.size() / 2);
    EXPECT_LT(resting, standing.size() * 9 / 10);
  }
}

// Metres a second that the shown clip's feet go over the ground without sticking to it.
double sliding_of(const Crowd& crowd, std::size_t agent, const glm::vec3& step) {
  const double stride = person().ground_speed(crowd.minds().roles()[agent]) *
                        static_cast<double>(crowd.scales()[agent]) *
                        static_cast<double>(crowd.playback_speeds()[agent]);
  const Heading heading = crowd.headings()[agent];
  const double x = 60.0 * static_cast<double>(step.x) - stride * static_cast<double>(heading.sine);
  const double z = 60.0 * static_cast<double>(step.z) - stride * static_cast<double>(heading.cosine);
  return std::sqrt(x * x + z * z);
}

TEST(Crowd, FeetHardlySlideInAnyScene) {
  for (const Scene scene : {Scene::plaza, Scene::parade, Scene::stadium, Scene::grid}) {
    Crowd crowd(scene, 500, 1, person());
    std::vector<glm::vec3> before(crowd.positions().begin(), crowd.positions().end());
    double sliding = 0.0;
    for (int i = 0; i < 1800; ++i) {
      crowd.advance(frame);
      for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
        sliding += sliding_of(crowd, agent, crowd.positions()[agent] - before[agent]);
      }
      std::ranges::copy(crowd.positions(), before.begin());
    }
    EXPECT_LT(sliding / 1800.0 / 500.0, 0.02) << "metres a second, of scene " << static_cast<int>(scene);
  }
}

TEST(Crowd, TurnsNoFasterThanAPersonDoes) {
  Crowd crowd(Scene::plaza, 300, 1, person());
  std::vector<Heading> before(crowd.headings().begin(), crowd.headings().end());
  for (int i = 0; i < 600; ++i) {
    crowd.advance(frame);
    for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
      const Heading now = crowd.headings()[agent];
      ASSERT_GT(now.cosine * before[agent].cosine + now.sine * before[agent].sine, 0.9965F) << "cosine of 4.8 degrees";
      before[agent] = now;
    }
  }
}

TEST(Crowd, OnlyWalkersMove) {
  Crowd crowd(Scene::plaza, 300, 1, person());
  const std::vector<glm::vec3> before(crowd.positions().begin(), crowd.positions().end());
  crowd.advance(frame);
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    EXPECT_EQ(crowd.positions()[agent] != before[agent], agent < crowd.walkers().count());
    EXPECT_EQ(crowd.minds().roles()[agent] == Role::walk, agent < crowd.walkers().count());
  }
}

TEST(Crowd, LanesAreClosed) {
  const Crowd crowd(Scene::plaza, 1000, 1, person());
  ASSERT_GT(crowd.walkers().lanes().size(), 3U);
  std::set<double> directions;
  for (const Lane& lane : crowd.walkers().lanes()) {
    const double length = lane.length();
    directions.insert(lane.direction);
    for (int part = 0; part < 20; ++part) {
      const LanePoint place = lane.at(length * part / 20.0);
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
  std::set<Tints> looks(crowd.looks().tints.begin(), crowd.looks().tints.end());
  EXPECT_GT(looks.size(), 1900U);
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    EXPECT_GE(crowd.scales()[agent], 0.9F);
    EXPECT_LE(crowd.scales()[agent], 1.08F);
    EXPECT_GE(crowd.playback_speeds()[agent], 0.8999F);
    EXPECT_LE(crowd.playback_speeds()[agent], 1.1001F);
    EXPECT_FLOAT_EQ(crowd.looks().radii[agent], 0.3F * crowd.scales()[agent]);
    EXPECT_LT(crowd.looks().start_phases[agent], 1.0F);
    const Heading heading = crowd.headings()[agent];
    EXPECT_NEAR(heading.cosine * heading.cosine + heading.sine * heading.sine, 1.0F, 1e-5F);
    for (const std::uint32_t tint : crowd.looks().tints[agent]) EXPECT_EQ(tint >> 24U, 0xFFU);
  }
}

TEST(Crowd, SitsDownAndStandsUpByTheClipsForThat) {
  CharacterRoles character = person();
  character.sit_down = {20, 2.0};
  character.stand_up = {21, 1.8};
  Crowd crowd(Scene::stadium, 200, 1, character);
  const int seat = character.clip(Role::sit);
  std::vector<int> shown(crowd.minds().clips().begin(), crowd.minds().clips().end());
  std::set<int> passages;
  for (int i = 0; i < 60 * 60; ++i) {
    for (const ClipRequest& request : crowd.advance(frame)) {
      const int before = std::exchange(shown[request.agent], request.clip);
      if (request.clip == 20 || request.clip == 21) passages.insert(request.clip);
      // Nobody takes a seat but by sitting down; only the wave makes them jump up.
      EXPECT_TRUE(request.clip != seat || before == 20);
      EXPECT_TRUE(request.clip != 21 || before == seat || before == 20);
      EXPECT_TRUE(before != 20 || request.clip == seat || request.clip == 21 || request.role == Role::cheer);
    }
  }
  EXPECT_EQ(passages, (std::set<int>{20, 21}));
}

/// Whether somebody would take one for the other: of one height to a centimetre, as stout, broad and stooped, with the
/// same hair and in clothes of the same colours.
bool are_twins(const Crowd& crowd, std::size_t a, std::size_t b) {
  const auto near = [](float one, float other, float most) { return std::abs(one - other) < most; };
  const auto alike = [](std::uint32_t one, std::uint32_t other) {
    for (const unsigned shift : {0U, 8U, 16U}) {
      const int difference = static_cast<int>((one >> shift) & 0xFFU) - static_cast<int>((other >> shift) & 0xFFU);
      if (std::abs(difference) > 24) return false;
    }
    return true;
  };
  const Variant& one = crowd.looks().variants[a];
  const Variant& other = crowd.looks().variants[b];
  return near(crowd.scales()[a] * 1.8F, crowd.scales()[b] * 1.8F, 0.01F) && near(one.build, other.build, 0.15F) &&
         near(one.frame, other.frame, 0.2F) && near(one.posture, other.posture, 0.2F) &&
         near(one.fullness, other.fullness, 0.3F) && near(one.length, other.length, 0.3F) &&
         std::ranges::equal(crowd.looks().tints[a], crowd.looks().tints[b], alike);
}

TEST(Crowd, OfAThousandShowsNoTwinBesideATwin) {
  constexpr float beside = 8.0F;  // metres
  for (const Scene scene : {Scene::plaza, Scene::grid, Scene::stadium}) {
    const Crowd crowd(scene, 1000, 1, person());
    for (std::size_t a = 0; a < crowd.size(); ++a) {
      for (std::size_t b = a + 1; b < crowd.size(); ++b) {
        if (glm::distance(crowd.positions()[a], crowd.positions()[b]) > beside) continue;
        EXPECT_FALSE(are_twins(crowd, a, b)) << a << " and " << b;
      }
    }
  }
}

TEST(Crowd, EveryRequestNamesAClipThatTheCharacterHasAndIsNotPlayingAlready) {
  Crowd crowd(Scene::plaza, 500, 1, person());
  std::vector<int> clips(crowd.minds().clips().begin(), crowd.minds().clips().end());
  std::set<Role> asked;
  for (int i = 0; i < 60 * 30; ++i) {
    for (const ClipRequest& request : crowd.advance(frame)) {
      EXPECT_EQ(request.clip, person().clip(request.role));
      EXPECT_NE(request.clip, no_clip);
      EXPECT_NE(request.clip, clips[request.agent]);
      EXPECT_GE(request.fade_seconds, 0.3F);
      EXPECT_LE(request.fade_seconds, 0.8F);
      clips[request.agent] = request.clip;
      asked.insert(request.role);
    }
  }
  EXPECT_TRUE(std::ranges::equal(crowd.minds().clips(), clips));
  EXPECT_EQ(asked, (std::set<Role>{Role::stand, Role::look_around, Role::walk, Role::jog, Role::run, Role::wave,
                                   Role::cheer, Role::clap, Role::sit}))
      << "some sit on benches";
}

TEST(Crowd, WithoutAWalkNobodyWalks) {
  CharacterRoles statue = person();
  statue.clips[index_of(Role::walk)] = no_clip;
  EXPECT_EQ(Crowd(Scene::plaza, 100, 1, statue).walkers().count(), 0U);
  CharacterRoles treadmill = person();
  treadmill.walk_speed = 0.0;
  EXPECT_EQ(Crowd(Scene::plaza, 100, 1, treadmill).walkers().count(), 0U);
}

TEST(Crowd, WithoutAJogOrARunEveryoneWalks) {
  Crowd crowd(Scene::plaza, 300, 1, character_with({Role::stand, Role::walk}));
  for (int i = 0; i < 60 * 30; ++i) {
    for (const ClipRequest& request : crowd.advance(frame)) {
      EXPECT_TRUE(request.role == Role::stand || request.role == Role::walk);
    }
    for (const float speed : crowd.speeds()) ASSERT_LT(speed, 1.3F * 1.08F * 1.06F * 1.16F);
  }
}

TEST(Crowd, WithNothingButAWalkWalkersGoOnForEver) {
  Crowd crowd(Scene::plaza, 100, 1, character_with({Role::walk}));
  for (int i = 0; i < 60 * 30; ++i) {
    for (const ClipRequest& request : crowd.advance(frame)) ASSERT_GE(request.agent, crowd.walkers().count());
  }
  for (std::size_t walker = 0; walker < crowd.walkers().count(); ++walker)
    EXPECT_EQ(crowd.minds().roles()[walker], Role::walk);
}

TEST(Crowd, WithoutAnIdleStandersTakeTurnsInWhatThereIs) {
  CharacterRoles roles;
  roles.others = {4, 7, 9};
  Crowd crowd(Scene::plaza, 30, 1, roles);
  EXPECT_EQ(std::set<int>(crowd.minds().clips().begin(), crowd.minds().clips().end()), (std::set<int>{4, 7, 9}));
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

TEST(Crowd, StandersTurnAsTheirClipDoes) {
  CharacterRoles turner;
  turner.others = {0};
  turner.turns = {0.5};  // an eighth of a turn a second
  Crowd crowd(Scene::plaza, 8, 1, turner);
  const std::vector<Heading> before(crowd.headings().begin(), crowd.headings().end());
  for (int i = 0; i < 60; ++i) crowd.advance(frame);
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    const Heading& from = before[agent];
    const Heading& to = crowd.headings()[agent];
    const float sine = from.cosine * to.sine - from.sine * to.cosine;
    EXPECT_NEAR(std::asin(sine), 0.785F * crowd.playback_speeds()[agent], 0.01F) << "to the left";
  }
}

TEST(Crowd, WithOneClipOrNoneNothingIsAsked) {
  CharacterRoles lone;
  lone.others = {0};
  Crowd one(Scene::plaza, 20, 1, lone), none(Scene::plaza, 20, 1, CharacterRoles{});
  EXPECT_EQ(one.minds().clips()[5], 0);
  EXPECT_EQ(none.minds().clips()[5], no_clip);
  for (int i = 0; i < 60 * 20; ++i) {
    EXPECT_TRUE(one.advance(frame).empty());
    EXPECT_TRUE(none.advance(frame).empty());
  }
}

TEST(Crowd, ALargerCharacterTakesMoreRoom) {
  CharacterRoles giant = person();
  giant.height = 18.0;
  const Crowd crowd(Scene::plaza, 100, 1, giant);
  EXPECT_GE(least_distance(crowd, crowd.walkers().count(), crowd.size()), 7.0F);
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
  EXPECT_EQ(crowd.walkers().count(), 0U);
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
  EXPECT_TRUE(crowd.advance(Ticks{}).empty());
  EXPECT_TRUE(std::ranges::equal(crowd.positions(), before));
}

}  // namespace
}  // namespace throng::app::crowd_test
