// Shares of a cast: how many agents are who, and in what order.

#include "app/people/crowd/numbers/shares.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::shares_test {
namespace {

using testing::ElementsAre;

CharacterRoles of_share(double share, CharacterRoles character = person()) {
  character.share = share;
  return character;
}

std::vector<std::ptrdiff_t> members(std::span<const std::uint8_t> numbers, std::size_t characters) {
  std::vector<std::ptrdiff_t> members;
  for (std::size_t i = 0; i < characters; ++i) {
    members.push_back(std::ranges::count(numbers, static_cast<std::uint8_t>(i)));
  }
  return members;
}

TEST(Shares, AreExactInEveryScene) {
  const std::vector cast{of_share(3), of_share(2), of_share(1)};
  for (const Scene scene : {Scene::plaza, Scene::grid, Scene::stadium}) {
    const Crowd crowd(scene, 600, 1, cast);
    EXPECT_THAT(members(crowd.characters(), 3), ElementsAre(300, 200, 100)) << static_cast<int>(scene);
  }
}

TEST(Shares, AreExactForEachKindOfPlace) {
  const std::vector cast{of_share(3), of_share(2), of_share(1), of_share(2, character_with({Role::stand}))};
  const Crowd crowd(Scene::plaza, 600, 5, cast);
  const auto walkers = static_cast<double>(crowd.walkers().count()), others = 600.0 - walkers;
  ASSERT_GT(crowd.walkers().count(), 100U);
  const auto walking = members(crowd.characters().first(crowd.walkers().count()), 4);
  const auto standing = members(crowd.characters().subspan(crowd.walkers().count()), 4);
  const std::array shares{3.0, 2.0, 1.0, 2.0};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(static_cast<double>(walking[i]), i < 3 ? walkers * shares[i] / 6.0 : 0.0, 1.0) << i;
    EXPECT_NEAR(static_cast<double>(standing[i]), others * shares[i] / 8.0, 2.0) << i;
  }
}

TEST(Shares, AreTheNearestWholeNumbersAndAddUp) {
  const std::vector cast{of_share(1), of_share(1), of_share(1)};
  for (const std::size_t agents : {1U, 2U, 3U, 4U, 100U, 101U}) {
    const auto counts = members(Crowd(Scene::grid, agents, 1, cast).characters(), 3);
    const auto [least, most] = std::ranges::minmax(counts);
    EXPECT_LE(most - least, 1) << agents;
    EXPECT_EQ(static_cast<std::size_t>(counts[0] + counts[1] + counts[2]), agents);
  }
}

TEST(Shares, WhatOneKindOfPlaceRoundsOffTheNextMakesGood) {
  const std::vector cast{of_share(1), of_share(1)};
  const std::array<std::uint8_t, 2> both{0, 1};
  ShareDealer dealer(cast);
  Random random(1, 1);
  EXPECT_THAT(members(dealer.deal(both, 1, random), 2), ElementsAre(1, 0));
  EXPECT_THAT(members(dealer.deal(both, 1, random), 2), ElementsAre(0, 1));
}

TEST(Shares, OfATinyPartAreNobodyAndNobodyIsLost) {
  const std::vector cast{of_share(1000), of_share(0.01)};
  EXPECT_THAT(members(Crowd(Scene::grid, 50, 1, cast).characters(), 2), ElementsAre(50, 0));
}

TEST(Shares, AreShuffledByTheSeed) {
  const std::vector cast{of_share(1), of_share(1)};
  const auto order = [&](std::uint32_t seed) {
    const Crowd crowd(Scene::grid, 400, seed, cast);
    return std::vector(crowd.characters().begin(), crowd.characters().end());
  };
  EXPECT_EQ(order(1), order(1));
  EXPECT_NE(order(1), order(2));
  std::size_t changes = 0;
  const auto one = order(1);
  for (std::size_t i = 1; i < one.size(); ++i) changes += one[i] != one[i - 1] ? 1U : 0U;
  EXPECT_GT(changes, 150U) << "neither blocks";
  EXPECT_LT(changes, 250U) << "nor stripes";
}

}  // namespace
}  // namespace throng::app::shares_test
