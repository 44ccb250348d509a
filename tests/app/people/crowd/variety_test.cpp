// Agents of one character differ: in size and in shade where its colours are its file's own.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::variety_test {
namespace {

using testing::AllOf;
using testing::Each;
using testing::Ge;
using testing::Le;

CharacterRoles painted() {
  CharacterRoles painted = person();
  painted.is_painted = true;
  return painted;
}

/// A channel of InstanceRecord::shade as the shader takes it: how many times as bright.
double times_as_bright(std::uint32_t shade, unsigned channel) {
  return 1.0 + static_cast<double>(render::shade_reach) * static_cast<std::int8_t>(shade >> 8U * channel) / 127.0;
}

Crowd crowd_of(const CharacterRoles& character, std::uint32_t seed = 1, const Variety& variety = {}) {
  return Crowd(Scene::plaza, 2000, seed, {&character, 1}, variety);
}

TEST(Variety, PaintedCharactersDifferInHeightAsPeopleDo) {
  const Crowd crowd = crowd_of(painted());
  EXPECT_THAT(crowd.scales(), Each(AllOf(Ge(0.9F), Le(1.1F))));
  double sum = 0.0, squares = 0.0;
  for (const float scale : crowd.scales()) {
    sum += static_cast<double>(scale);
    squares += static_cast<double>(scale) * static_cast<double>(scale);
  }
  const auto count = static_cast<double>(crowd.size());
  const double mean = sum / count;
  EXPECT_NEAR(mean, 1.0, 0.005);
  EXPECT_NEAR(std::sqrt(squares / count - mean * mean), 0.04, 0.004);
}

TEST(Variety, ShadesStayCloseToTheFilesColours) {
  const Crowd crowd = crowd_of(painted());
  for (const std::uint32_t shade : crowd.looks().shades) {
    const double red = times_as_bright(shade, 0), green = times_as_bright(shade, 1), blue = times_as_bright(shade, 2);
    EXPECT_NEAR(std::sqrt(green), 1.0, 0.102);         // as the screen counts
    EXPECT_NEAR(std::sqrt(red / green), 1.0, 0.043);   // no warmer or cooler
    EXPECT_NEAR(std::sqrt(blue / green), 1.0, 0.043);  // than that
    EXPECT_NEAR(std::sqrt(red * blue), green, 0.01) << "neither green nor purple";
  }
  EXPECT_GT(std::set(crowd.looks().shades.begin(), crowd.looks().shades.end()).size(), 1500U);
}

TEST(Variety, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const Crowd one = crowd_of(painted()), again = crowd_of(painted()), other = crowd_of(painted(), 2);
  EXPECT_TRUE(std::ranges::equal(one.scales(), again.scales()));
  EXPECT_TRUE(std::ranges::equal(one.looks().shades, again.looks().shades));
  EXPECT_FALSE(std::ranges::equal(one.scales(), other.scales()));
  EXPECT_FALSE(std::ranges::equal(one.looks().shades, other.looks().shades));
}

TEST(Variety, HasLooksToDrawWhoseNumberNoOtherCrowdHas) {
  const Crowd one = crowd_of(person()), again = crowd_of(person());
  ASSERT_EQ(one.looks().drawn.size(), one.size());
  for (std::size_t agent = 0; agent < one.size(); ++agent) {
    const render::AgentLook& look = one.looks().drawn[agent];
    EXPECT_EQ(look.tints[2], one.looks().tints[agent][2] & 0xFFFFFFU) << "in plain cotton";
    EXPECT_EQ(look.shape, one.looks().variants[agent].shape());
    EXPECT_EQ(look.hair, one.looks().variants[agent].hair());
  }
  EXPECT_EQ(one.looks().drawn, again.looks().drawn);
  EXPECT_NE(one.looks().number, again.looks().number) << "who has drawn one copies the other all the same";
}

TEST(Variety, LeavesTheFirstOfEachPaintedCharacterAsItsFileHasIt) {
  const std::vector cast{painted(), painted()};
  const Crowd crowd(Scene::grid, 40, 3, cast);
  for (const std::uint8_t character : {std::uint8_t{0}, std::uint8_t{1}}) {
    const auto first = std::ranges::find(crowd.characters(), character) - crowd.characters().begin();
    EXPECT_EQ(crowd.scales()[static_cast<std::size_t>(first)], 1.0F);
    EXPECT_EQ(crowd.looks().shades[static_cast<std::size_t>(first)], 0U);
  }
  EXPECT_EQ(std::ranges::count(crowd.looks().shades, 0U), 2);
}

TEST(Variety, OfCharactersWithTintRegionsIsInTheirClothes) {
  const Crowd crowd = crowd_of(person());
  EXPECT_THAT(crowd.looks().shades, Each(0U));
  EXPECT_NE(crowd.looks().tints[0], crowd.looks().tints[1]);
}

TEST(Variety, OffMakesAllOfOneCharacterAlike) {
  for (const CharacterRoles& character : {person(), painted()}) {
    const Crowd crowd = crowd_of(character, 1, {.differs = false});
    EXPECT_THAT(crowd.scales(), Each(1.0F));
    EXPECT_THAT(crowd.looks().shades, Each(0U));
    EXPECT_THAT(crowd.looks().tints, Each(crowd.looks().tints[0]));
    EXPECT_THAT(crowd.looks().variants, Each(Variant()));
  }
}

float largest_difference_in_size(const Crowd& crowd) {
  float largest = 0.0F;
  for (const float scale : crowd.scales()) largest = std::max(largest, std::abs(scale - 1.0F));
  return largest;
}

TEST(Variety, InSizeIsAsMuchAsWanted) {
  for (const CharacterRoles& character : {person(), painted()}) {
    EXPECT_EQ(largest_difference_in_size(crowd_of(character, 1, {.size = 0.0F})), 0.0F);
    const float usual = largest_difference_in_size(crowd_of(character));
    EXPECT_NEAR(largest_difference_in_size(crowd_of(character, 1, {.size = 0.3F})), 3.0F * usual, 1e-5F);
  }
}

TEST(Variety, InColoursIsAsMuchAsWanted) {
  EXPECT_THAT(crowd_of(painted(), 1, {.tint = 0.0F}).looks().shades, Each(0U));
  const Crowd alike = crowd_of(person(), 1, {.tint = 0.0F});
  EXPECT_THAT(alike.looks().tints, Each(alike.looks().tints[0]));
  EXPECT_NE(alike.looks().variants[0], alike.looks().variants[1]) << "shapes differ as before";
  const Crowd full = crowd_of(painted()), half = crowd_of(painted(), 1, {.tint = 0.5F});
  for (std::size_t agent = 0; agent < full.size(); ++agent) {
    const double far = times_as_bright(full.looks().shades[agent], 0) - 1.0;
    EXPECT_NEAR(times_as_bright(half.looks().shades[agent], 0) - 1.0, far / 2.0, 0.01) << agent;
  }
}

TEST(Variety, OfColoursDoesNotChangeSizesAndTheOtherWayRound) {
  const Crowd usual = crowd_of(painted()), pale = crowd_of(painted(), 1, {.tint = 0.2F}),
              large = crowd_of(painted(), 1, {.size = 0.3F});
  EXPECT_TRUE(std::ranges::equal(usual.scales(), pale.scales()));
  EXPECT_TRUE(std::ranges::equal(usual.looks().shades, large.looks().shades));
}

TEST(Variety, EntersTheSpeedSoThatFeetDoNotSlide) {
  const Crowd crowd = crowd_of(painted());
  for (std::size_t walker = 0; walker < crowd.walkers().count(); ++walker) {
    const double stride = person().ground_speed(crowd.minds().roles()[walker]) *
                          static_cast<double>(crowd.scales()[walker]) *
                          static_cast<double>(crowd.playback_speeds()[walker]);
    EXPECT_NEAR(stride, static_cast<double>(crowd.speeds()[walker]), 1e-4) << walker;
  }
}

TEST(Variety, OfOneCharacterChangesNothingOfAnother) {
  const std::vector both{person(), painted()}, plain{person(), person()};
  const Crowd one(Scene::grid, 60, 1, both), other(Scene::grid, 60, 1, plain);
  for (std::size_t agent = 0; agent < one.size(); ++agent) {
    if (one.characters()[agent] != 0) continue;
    EXPECT_EQ(one.scales()[agent], other.scales()[agent]);
    EXPECT_EQ(one.looks().tints[agent], other.looks().tints[agent]);
    EXPECT_EQ(one.looks().start_phases[agent], other.looks().start_phases[agent]);
  }
}

}  // namespace
}  // namespace throng::app::variety_test
