#include "app/people/crowd/clothes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "app/people/crowd/lettering.h"
#include "app/people/crowd/numbers/turn.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::clothes_test {
namespace {

constexpr Variety pattern{.clothes = Clothes::pattern};
constexpr CameraPose tower{.y = 50.0F, .pitch = -17.0F, .field_of_view = 45.0F};

// The part of the picture that the crowd of these tests fills.
constexpr glm::dvec2 low(-1.7, -0.95), high(1.7, 0.6);
constexpr double letters = 0.84 * 3.4 / (word_width + 0.5);  // the height of letters that fill as much of its width

/// Pairs a place with where a person who stands there is seen in the picture, from -1 at the bottom to 1 at the top.
glm::dvec3 standing_at(glm::dvec2 seen) {
  constexpr double degree = std::numbers::pi / 180.0, chest = 1.2;
  const double pitch = degree * static_cast<double>(tower.pitch);
  const glm::dvec2 aside = std::tan(0.5 * degree * static_cast<double>(tower.field_of_view)) * seen;
  const glm::dvec3 way(aside.x, std::sin(pitch) + aside.y * std::cos(pitch),
                       aside.y * std::sin(pitch) - std::cos(pitch));
  const double height = static_cast<double>(tower.y);
  return glm::dvec3(0.0, height - chest, 0.0) + way * ((chest - height) / way.y);
}

struct Color {
  double red = 0.0, green = 0.0, blue = 0.0;
  bool is_white() const { return red > 180.0 && green > 180.0 && blue > 180.0; }
  bool is_gold() const { return red > 200.0 && green > 150.0 && blue < 100.0; }
};

/// The mean colour of the shirts that many people at one place would wear.
Color mean_shirt(const ClothesPattern& clothes, const glm::dvec3& place) {
  Random random(1, 2), own(3, 4);
  constexpr int people = 100;
  Color sum;
  for (int person = 0; person < people; ++person) {
    const std::uint32_t shirt = clothes.at(place, random_tints(own), random)[2];
    sum.red += (shirt & 0xFFU) / static_cast<double>(people);
    sum.green += (shirt >> 8U & 0xFFU) / static_cast<double>(people);
    sum.blue += (shirt >> 16U & 0xFFU) / static_cast<double>(people);
  }
  return sum;
}

ClothesPattern word() {
  const std::array<glm::dvec3, 4> corners{standing_at(low), standing_at(high), standing_at({low.x, high.y}),
                                          standing_at({high.x, low.y})};
  return {Motif::word, corners, tower};
}

/// How often something begins along a line across the picture at that share of the letters' height.
int strokes_at(const ClothesPattern& clothes, double share) {
  const double y = 0.5 * (low.y + high.y) + (share - 0.5) * letters;
  int begun = 0;
  bool inside = false;
  for (double x = low.x; x < high.x; x += 0.01) {
    const bool now = mean_shirt(clothes, standing_at({x, y})).is_white();
    if (now && !inside) ++begun;
    inside = now;
  }
  return begun;
}

TEST(ClothesPattern, WritesAWordThatIsRightInThePictureFromTheTower) {
  const ClothesPattern clothes = word();
  EXPECT_EQ(strokes_at(clothes, 0.35), 1 + 2 + 2 + 2 + 3 + 2) << "T H R O N G";
  EXPECT_EQ(strokes_at(clothes, 0.65), 1 + 2 + 2 + 2 + 3 + 1);
  EXPECT_EQ(strokes_at(clothes, 1.3), 0) << "above the word";
  // The first letter's stem is upright in the picture and as wide at its foot as under its bar.
  const double stem = 0.5 * (low.x + high.x) + (0.36 - 0.5 * word_width) * letters, middle = 0.5 * (low.y + high.y);
  for (const double share : {0.05, 0.3, 0.6}) {
    const double y = middle + (share - 0.5) * letters;
    EXPECT_TRUE(mean_shirt(clothes, standing_at({stem, y})).is_white()) << share;
    EXPECT_FALSE(mean_shirt(clothes, standing_at({stem - 0.16 * letters, y})).is_white()) << share;
    EXPECT_FALSE(mean_shirt(clothes, standing_at({stem + 0.16 * letters, y})).is_white()) << share;
  }
}

TEST(ClothesPattern, LetsASunRiseAtTheFarEnd) {
  const ClothesPattern clothes = word();
  EXPECT_TRUE(mean_shirt(clothes, standing_at({0.0, high.y - 0.1})).is_gold());
  int changes = 0;
  bool bright = false;
  for (int step = 1; step < 100; ++step) {  // around it, half a turn
    const glm::dvec2 way = cosine_sine(-step / 50.0);
    const bool now = mean_shirt(clothes, standing_at(glm::dvec2(0.0, high.y) + 0.35 * way)).green > 60.0;
    if (step > 1 && now != bright) ++changes;
    bright = now;
  }
  EXPECT_NEAR(changes, 32, 2) << "sixteen rays begin and end";
}

TEST(ClothesPattern, HasRingsThatMarchersNeverLeave) {
  const std::array<glm::dvec3, 3> ends{glm::dvec3(-100.0, 0.0, -60.0), glm::dvec3(100.0, 0.0, 60.0),
                                       glm::dvec3(0.0, 0.0, 20.0)};
  const ClothesPattern clothes(Motif::rings, ends, tower);
  std::set<int> greens;
  for (double out = 21.0; out < 60.0; out += 2.0) {
    const Color straight = mean_shirt(clothes, {10.0, 0.0, out}), end = mean_shirt(clothes, {-40.0 - out, 0.0, 0.0});
    greens.insert(static_cast<int>(straight.green) / 16);
    EXPECT_NEAR(straight.green, end.green, 1.0) << out;
    EXPECT_NEAR(straight.blue, end.blue, 1.0) << out;
  }
  EXPECT_GE(greens.size(), 4U);
}

TEST(ClothesPattern, LeavesSkinAndHairAndAFewPeopleAsTheyAre) {
  const std::vector<CharacterRoles> people{person()};
  const Crowd own(Scene::stadium, 2000, 1, people, {}), dressed(Scene::stadium, 2000, 1, people, pattern);
  int alike = 0;
  for (std::size_t agent = 0; agent < own.size(); ++agent) {
    EXPECT_EQ(own.positions()[agent], dressed.positions()[agent]);
    EXPECT_EQ(own.looks().tints[agent][0], dressed.looks().tints[agent][0]) << "skin";
    EXPECT_EQ(own.looks().tints[agent][1], dressed.looks().tints[agent][1]) << "hair";
    if (own.looks().tints[agent][2] == dressed.looks().tints[agent][2]) ++alike;
  }
  EXPECT_GT(alike, 20);
  EXPECT_LT(alike, 120);
}

TEST(ClothesPattern, IsOfEveryScene) {
  for (const Scene scene : {Scene::plaza, Scene::parade, Scene::stadium, Scene::grid}) {
    for (const std::size_t agents : {1U, 60U}) {
      const std::vector<CharacterRoles> people{person()};
      const Crowd crowd(scene, agents, 1, people, pattern);
      EXPECT_EQ(crowd.looks().tints.size(), agents);
    }
  }
}

}  // namespace
}  // namespace throng::app::clothes_test
