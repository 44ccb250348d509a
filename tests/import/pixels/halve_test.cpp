#include "engine/anim/import/pixels/halve.h"

#include <cstdint>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::import::testing::halve_test {
namespace {

using ::testing::ElementsAre;

TEST(HalvedImage, HasTheMeanOfFourTexelsAndRepeatsAnOddEdge) {
  const std::vector<std::uint8_t> rgba{0,  10, 20, 255, 100, 10, 20, 255, 7, 7, 7, 7,  //
                                       50, 10, 22, 255, 50,  10, 22, 0,   9, 9, 9, 9};
  const anim::Image half = halved({.width = 3, .height = 2, .rgba = rgba});
  EXPECT_EQ(half.width, 2);
  EXPECT_EQ(half.height, 1);
  EXPECT_THAT(half.rgba, ElementsAre(50, 10, 21, 191, 8, 8, 8, 8));
}

}  // namespace
}  // namespace throng::import::testing::halve_test
