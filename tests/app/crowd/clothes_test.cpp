#include "app/crowd/clothes.h"

#include <array>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "app/crowd/crowd.h"
#include "app/crowd/turn.h"
#include "tests/app/crowd/crowd_person.h"

namespace throng::app::clothes_test {
namespace {

constexpr Variety pattern{.pattern = true};
constexpr std::array<glm::dvec2, 2> corners{glm::dvec2(-100.0, -60.0), glm::dvec2(100.0, 60.0)};

std::array<int, 3> channels(std::uint32_t tint) {
  return {static_cast<int>(tint & 0xFFU), static_cast<int>(tint >> 8U & 0xFFU), static_cast<int>(tint >> 16U & 0xFFU)};
}

/// The mean colour of the shirts that many people at one place would wear.
std::array<double, 3> mean_shirt(glm::dvec2 place) {
  const ClothesPattern clothes(corners);
  Random random(1, 2), own(3, 4);
  std::array<double, 3> sum{};
  constexpr int people = 200;
  for (int person = 0; person < people; ++person) {
    const auto shirt = channels(clothes.at(place, random_tints(own), random)[2]);
    for (std::size_t channel = 0; channel < sum.size(); ++channel) {
      sum.at(channel) += static_cast<double>(shirt.at(channel)) / people;
    }
  }
  return sum;
}

TEST(ClothesPattern, HasASunInTheMiddleAndRingsOfOtherColoursAroundIt) {
  const auto sun = mean_shirt({0.0, 0.0}), ring = mean_shirt({95.0, 0.0});
  EXPECT_GT(sun[0], sun[2] + 100) << "gold";
  EXPECT_GT(ring[2], ring[0]) << "no gold out here";
  std::set<int> greens;
  for (int along = 0; along < 40; ++along) greens.insert(static_cast<int>(mean_shirt({2.5 * along, 0.0})[1]) / 16);
  EXPECT_GE(greens.size(), 4U) << "from the middle to the edge";
}

TEST(ClothesPattern, HasRaysAroundTheSun) {
  int changes = 0;
  bool gold = false;
  for (int step = 0; step < 360; ++step) {
    const glm::dvec2 way = cosine_sine(step / 90.0);
    const bool now = mean_shirt(0.3 * way * glm::dvec2(100.0, 60.0))[1] > 130;
    if (step > 0 && now != gold) ++changes;
    gold = now;
  }
  EXPECT_NEAR(changes, 24, 1) << "twelve rays begin and end";
}

TEST(ClothesPattern, LeavesSkinAndHairAndAFewPeopleAsTheyAre) {
  const std::vector<CharacterRoles> people{person()};
  const Crowd own(Scene::plaza, 1000, 1, people, {}), dressed(Scene::plaza, 1000, 1, people, pattern);
  int alike = 0;
  for (std::size_t agent = 0; agent < own.size(); ++agent) {
    EXPECT_EQ(own.positions()[agent], dressed.positions()[agent]);
    EXPECT_EQ(own.tints()[agent][0], dressed.tints()[agent][0]) << "skin";
    EXPECT_EQ(own.tints()[agent][1], dressed.tints()[agent][1]) << "hair";
    if (own.tints()[agent][2] == dressed.tints()[agent][2]) ++alike;
  }
  EXPECT_GT(alike, 20);
  EXPECT_LT(alike, 120);
}

TEST(ClothesPattern, IsOfEveryScene) {
  for (const Scene scene : {Scene::parade, Scene::stadium, Scene::grid}) {
    for (const std::size_t agents : {1U, 60U}) {
      const std::vector<CharacterRoles> people{person()};
      const Crowd crowd(scene, agents, 1, people, pattern);
      EXPECT_EQ(crowd.tints().size(), agents);
    }
  }
}

}  // namespace
}  // namespace throng::app::clothes_test
