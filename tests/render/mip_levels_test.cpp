#include "engine/render/mesh/mip_levels.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::render::mip_levels_test {
namespace {

using testing::Each;
using testing::ElementsAre;

std::vector<std::vector<std::uint8_t>> levels_of(int width, int height, const std::vector<std::uint8_t>& rgba,
                                                 ImageKind kind) {
  return mip_levels({width, height, rgba}, kind);
}

// Black and white, side by side and below each other.
const std::vector<std::uint8_t> chequered = {0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0};

TEST(MipLevels, OfColorsAreTheMeanOfTheirLight) {
  EXPECT_THAT(levels_of(2, 2, chequered, ImageKind::colors), ElementsAre(ElementsAre(188, 188, 188, 128)));
}

TEST(MipLevels, OfNumbersAreTheirMean) {
  EXPECT_THAT(levels_of(2, 2, chequered, ImageKind::numbers), ElementsAre(Each(128)));
}

TEST(MipLevels, OfOneColorKeepIt) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::vector<std::uint8_t> plain(4 * 4 * 4, static_cast<std::uint8_t>(byte));
    EXPECT_THAT(levels_of(4, 4, plain, ImageKind::colors), Each(Each(byte))) << byte;
  }
}

TEST(MipLevels, HalveAnySizeDownToOnePixel) {
  const auto levels = levels_of(5, 3, std::vector<std::uint8_t>(5 * 3 * 4, 9), ImageKind::numbers);
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_EQ(levels[0].size(), 2 * 1 * 4U);
  EXPECT_EQ(levels[1].size(), 1 * 1 * 4U);
  EXPECT_TRUE(levels_of(1, 1, {1, 2, 3, 4}, ImageKind::colors).empty());
}

}  // namespace
}  // namespace throng::render::mip_levels_test
