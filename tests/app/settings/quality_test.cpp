#include "app/settings/quality.h"

#include <gtest/gtest.h>

namespace throng::app::quality_test {
namespace {

TEST(Quality, IsTakenAndFoundByItsName) {
  for (const char* const name : {"low", "medium", "high", "auto"}) {
    Tuning tuning;
    tuning.agents = 17;
    EXPECT_TRUE(take_quality(name, tuning)) << name;
    EXPECT_EQ(quality_of(tuning), name);
    EXPECT_EQ(tuning.agents, 17) << "a quality says what a picture costs, not what it shows";
  }
}

TEST(Quality, OfAnotherNameChangesNothing) {
  Tuning tuning;
  EXPECT_FALSE(take_quality("best", tuning));
  EXPECT_EQ(tuning, Tuning());
}

TEST(Quality, OfValuesSetByHandHasNoName) {
  Tuning tuning;
  tuning.picture_size = 99;
  EXPECT_EQ(quality_of(tuning), "");
}

TEST(Quality, ThatIsHighIsTheDefaultPicture) { EXPECT_EQ(quality_of(Tuning()), "high"); }

TEST(PictureCosts, GiveNothingBackOnTheWayDown) {
  const auto triangles = [](const PictureCost& cost) {
    return cost.triangle_budget == 0 ? 1 << 30 : cost.triangle_budget;
  };
  for (std::size_t i = 1; i < picture_costs.size(); ++i) {
    const PictureCost &before = picture_costs.at(i - 1), &cost = picture_costs.at(i);
    EXPECT_NE(cost, before) << i;
    EXPECT_LE(cost.picture_size, before.picture_size) << i;
    EXPECT_LE(triangles(cost), triangles(before)) << i;
    EXPECT_LE(cost.shadows, before.shadows) << i;
    EXPECT_LE(cost.crowd_shade, before.crowd_shade) << i;
  }
}

TEST(PictureCosts, StayWithinTheRangesOfTheirValues) {
  for (const PictureCost& cost : picture_costs) {
    EXPECT_GE(cost.picture_size, 25);
    EXPECT_LE(cost.picture_size, 100);
  }
}

}  // namespace
}  // namespace throng::app::quality_test
