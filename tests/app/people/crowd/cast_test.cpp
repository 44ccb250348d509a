// Several characters in one crowd: who is which.

#include "app/people/crowd/cast.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::cast_test {
namespace {

using testing::Each;

CharacterRoles statue() { return character_with({Role::stand}); }

CharacterRoles giant() {
  CharacterRoles giant = person();
  giant.height *= 2.0;
  giant.walk_speed *= 1.5;
  return giant;
}

std::array<std::ptrdiff_t, 2> members_of(std::span<const std::uint8_t> characters) {
  return {std::ranges::count(characters, 0), std::ranges::count(characters, 1)};
}

TEST(CrowdCast, EveryCharacterGetsItsShareOfTheCrowd) {
  const std::vector characters = {person(), giant()};
  for (const Scene scene : {Scene::plaza, Scene::grid, Scene::stadium}) {
    const Crowd crowd(scene, 400, 1, characters);
    for (const std::ptrdiff_t members : members_of(crowd.characters())) EXPECT_GT(members, 150);
  }
}

TEST(CrowdCast, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const std::vector characters = {person(), giant()};
  const auto cast = [&](std::uint32_t seed) {
    const Crowd crowd(Scene::plaza, 200, seed, characters);
    return std::vector(crowd.characters().begin(), crowd.characters().end());
  };
  EXPECT_EQ(cast(1), cast(1));
  EXPECT_NE(cast(1), cast(2));
}

TEST(CrowdCast, OnlyThoseWhoCanWalkAreWalkers) {
  const std::vector characters = {statue(), person()};
  const Crowd crowd(Scene::plaza, 300, 1, characters);
  ASSERT_GT(crowd.walkers().count(), 0U);
  EXPECT_THAT(crowd.characters().first(crowd.walkers().count()), Each(1));
  EXPECT_GT(members_of(crowd.characters().subspan(crowd.walkers().count()))[0], 0);
}

TEST(CrowdCast, ThoseWhoMarchInStepAreOfOneCharacter) {
  const std::vector characters = {statue(), person(), giant()};
  const Crowd crowd(Scene::parade, 300, 1, characters);
  ASSERT_GT(crowd.marchers().count(), 0U);
  EXPECT_THAT(crowd.characters().subspan(crowd.walkers().count(), crowd.marchers().count()), Each(1));
}

TEST(CrowdCast, EverybodyPlaysClipsOfTheirOwnAndWalksAtTheirOwnSpeed) {
  CharacterRoles other = giant();
  for (int& clip : other.clips) clip += 100;
  const std::vector characters = {person(), other};
  Crowd crowd(Scene::plaza, 200, 1, characters);
  for (int frame = 0; frame < 300; ++frame) {
    for (const ClipRequest& request : crowd.advance(ticks_per_second / 60)) {
      EXPECT_EQ(request.clip >= 100, crowd.characters()[request.agent] == 1);
    }
  }
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    EXPECT_EQ(crowd.minds().clips()[agent] >= 100, crowd.characters()[agent] == 1) << agent;
  }
}

TEST(CrowdCast, KeepsItsDistanceByTheWidest) {
  const std::vector characters = {person(), giant()};
  Crowd crowd(Scene::plaza, 200, 1, characters);
  for (int frame = 0; frame < 600; ++frame) {
    crowd.advance(ticks_per_second / 60);
    for (std::size_t a = 0; a < crowd.size(); ++a) {
      for (std::size_t b = a + 1; b < crowd.size(); ++b) {
        const float apart = glm::distance(crowd.positions()[a], crowd.positions()[b]);
        ASSERT_GT(apart, 0.8F * (crowd.looks().radii[a] + crowd.looks().radii[b]))
            << a << ", " << b << ", frame " << frame;
      }
    }
  }
}

TEST(CommonRoles, HaveTheGaitOfTheFirstThatCanWalkAndTheRoomOfTheLargest) {
  const std::vector characters = {statue(), person(), giant()};
  const CharacterRoles common = common_roles(characters);
  EXPECT_EQ(common.walk_speed, person().walk_speed);
  EXPECT_EQ(common.height, giant().height);
  CharacterRoles still = statue();
  still.walk_speed = 0.0;
  EXPECT_FALSE(common_roles({&still, 1}).can_walk());
}

}  // namespace
}  // namespace throng::app::cast_test
