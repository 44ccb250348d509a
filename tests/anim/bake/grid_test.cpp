#include "engine/anim/bake/grid.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/anim/asset/clip_fixtures.h"

namespace throng::anim::grid_test {
namespace {

/// Times of keys n / rate + first, as a file holds them: 32-bit seconds.
std::vector<Ticks> file_times(double rate, const std::vector<int>& steps, double first = 0.0) {
  std::vector<Ticks> times;
  for (const int step : steps) times.push_back(key_ticks(static_cast<double>(static_cast<float>(first + step / rate))));
  return times;
}

class GridOfRate : public testing::TestWithParam<double> {};

TEST_P(GridOfRate, IsFoundWithItsPhase) {
  for (const double first : {0.0, 0.0123, 7.5}) {
    const auto grid = find_grid(file_times(GetParam(), {0, 1, 2, 3, 5, 8, 13, 14, 47, 300}, first));
    ASSERT_TRUE(grid) << first;
    EXPECT_NEAR(grid->rate, GetParam(), 2e-4 * GetParam());
    EXPECT_NEAR(to_seconds(grid->first), first, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Rates, GridOfRate,
                         testing::Values(10.0, 24.0, 25.0, 30.0, 60.0, 120.0, 24000.0 / 1001.0, 30000.0 / 1001.0,
                                         41.7));

TEST(KeyGrid, IsTheCoarsestThatHoldsAllKeys) {
  const auto grid = find_grid(file_times(30.0, {0, 10, 25, 40}));
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->rate, 6.0);
}

TEST(KeyGrid, OfKeysSecondsApartHasAtLeastOneHertz) {
  const auto grid = find_grid(file_times(1.0 / 3.7, {0, 1, 4}));
  ASSERT_TRUE(grid);
  EXPECT_GE(grid->rate, 1.0);
  EXPECT_NEAR(std::remainder(3.7 * grid->rate, 1.0), 0.0, 1e-4);
}

TEST(KeyGrid, IsNotFoundAmongUnevenKeys) {
  std::vector<Ticks> times;
  for (int key = 0; key < 30; ++key) times.push_back(to_ticks(std::sqrt(2.0 + key)));
  EXPECT_FALSE(find_grid(times));
}

TEST(KeyGrid, IsNotFoundAboveTheHighestRate) { EXPECT_FALSE(find_grid(file_times(150.0, {0, 1, 2, 3, 4, 5, 6, 7}))); }

TEST(KeyGrid, ForgivesTimesWrittenInDecimals) {
  std::vector<Ticks> times;
  for (int key = 0; key <= 90; ++key) times.push_back(to_ticks(std::round(key / 30.0 * 1e5) / 1e5));
  const auto grid = find_grid(times);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->rate, 30.0);
}

TEST(KeyTimes, ListMovingTracksOnlyEachTimeOnce) {
  const Model model = one_bone_model();
  BoneTracks tracks;
  tracks.translation = sampled_track([](float time) { return glm::vec3(time); }, 10.0, 10);
  tracks.rotation = {Interpolation::linear, {0.0F, 0.777F}, {{1.0F, 0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F, 0.0F}}};
  EXPECT_EQ(key_times(to_state_space(model.skeleton, one_bone_clip(tracks, 1.0))).size(), 11U);
}

}  // namespace
}  // namespace throng::anim::grid_test
