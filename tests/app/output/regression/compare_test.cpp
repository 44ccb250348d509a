#include "app/output/regression/compare.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/output/regression/tolerance.h"

namespace throng::app::compare_test {
namespace {

using render::Image;
using testing::HasSubstr;

void paint_block(Image& image, int left, int top, std::uint8_t value) {
  for (int y = top; y < top + 16; ++y) {
    for (int x = left; x < left + 16; ++x) std::fill_n(image.pixel(x, y), 3, value);
  }
}

TEST(PictureDifference, OfEqualPicturesIsNothing) {
  const auto difference = measure_difference(Image::blank(100, 50), Image::blank(100, 50));
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->mean, 0.0);
  EXPECT_EQ(difference->worst_block, 0.0);
}

TEST(PictureDifference, FindsTheOneBlockThatDiffers) {
  Image changed = Image::blank(640, 360);
  paint_block(changed, 320, 160, 55);
  const auto difference = measure_difference(Image::blank(640, 360), changed);
  ASSERT_TRUE(difference);
  EXPECT_DOUBLE_EQ(difference->worst_block, 200.0);
  EXPECT_EQ(difference->worst_block_x, 320);
  EXPECT_EQ(difference->worst_block_y, 160);
  EXPECT_NEAR(difference->mean, 200.0 * 256 / (640 * 360), 1e-9);
}

TEST(PictureDifference, CountsBlocksThatTheEdgeCutsByTheirOwnSize) {
  Image changed = Image::blank(20, 20);
  for (int y = 16; y < 20; ++y) {
    for (int x = 16; x < 20; ++x) std::fill_n(changed.pixel(x, y), 3, std::uint8_t{155});
  }
  const auto difference = measure_difference(Image::blank(20, 20), changed);
  ASSERT_TRUE(difference);
  EXPECT_DOUBLE_EQ(difference->worst_block, 100.0);
}

TEST(PictureDifference, IsRefusedForDifferentSizes) {
  const auto difference = measure_difference(Image::blank(20, 20), Image::blank(20, 21));
  ASSERT_FALSE(difference);
  EXPECT_NE(difference.error().message.find("20x21"), std::string::npos);
}

TEST(PictureDifference, CountsPixelsThatArePlainlyOther) {
  Image changed = Image::blank(100, 100);
  changed.pixel(3, 3)[1] = 255 - seen_steps;
  changed.pixel(4, 3)[1] = 255 - seen_steps - 1;
  EXPECT_DOUBLE_EQ(measure_difference(Image::blank(100, 100), changed)->share, 0.0001);
}

TEST(PictureDifference, IsPaintedBrighterAndAsHeatWithAFrame) {
  Image changed = Image::blank(64, 64);
  paint_block(changed, 16, 32, 155);
  const Image expected = Image::blank(64, 64);
  const Image difference = paint_difference(expected, changed);
  EXPECT_EQ(difference.pixel(0, 0)[0], 0);
  EXPECT_EQ(difference.pixel(16, 32)[0], 255);
  changed.pixel(0, 0)[2] = 254;
  const Image heat = paint_heat(expected, changed, *measure_difference(expected, changed));
  const auto color = [&](int x, int y) {
    const std::uint8_t* const pixel = heat.pixel(x, y);
    return std::to_string(pixel[0]) + "," + std::to_string(pixel[1]) + "," + std::to_string(pixel[2]);
  };
  EXPECT_EQ(color(20, 40), "230,30,30") << "far off: red";
  EXPECT_EQ(color(0, 0), "60,90,220") << "a step: blue";
  EXPECT_EQ(color(15, 40), "255,0,255") << "the frame";
  EXPECT_EQ(color(50, 50), "142,142,142") << "the same: grey";
}

TEST(Bits, OfAChannelAreCutAndWhiteStays) {
  Image image = Image::blank(2, 1);
  image.pixel(0, 0)[0] = 0x7F;
  EXPECT_EQ(rounded_to_bits(image, 6).pixel(0, 0)[0], 0x7C);
  EXPECT_EQ(rounded_to_bits(image, 8).pixel(0, 0)[0], 0x7F);
  EXPECT_EQ(rounded_to_bits(image, 1).pixel(1, 0)[0], 255);
}

TEST(Bits, AreCutOfColoursAlone) {
  render::NumberImage deep = render::in_16_bits(Image::blank(2, 1));
  deep.numbers[0] = 0x7F7F;
  EXPECT_EQ(rounded_to_bits({deep, PixelKind::colours}, 6).image.numbers[0], 0x7C7C);
  deep.numbers[0] = 0x7F80;
  EXPECT_EQ(rounded_to_bits({deep, PixelKind::colours}, 8).image.numbers[0], 0x7F80);
  EXPECT_EQ(rounded_to_bits({deep, PixelKind::labels}, 6).image.numbers[0], 0x7F80);
}

TEST(Tolerance, HoldsToNothingButTheSameWhereItHasNoLimit) {
  EXPECT_TRUE(all_within(judge({}, {})));
  EXPECT_FALSE(all_within(judge({.mean = 1e-6}, {})));
}

TEST(Tolerance, CountsTheLimitsThatItHas) {
  const PictureDifference difference{.mean = 1, .worst_block = 20, .worst_block_x = 32, .share = 0.5};
  EXPECT_TRUE(all_within(judge(difference, {.mean = DifferenceLimit{1, "outlines"}})));
  const auto figures =
      judge(difference, {.mean = DifferenceLimit{0.5, "outlines"}, .worst_block = DifferenceLimit{9, "hands"}});
  EXPECT_EQ(excess_text(figures), "mean 1.000, at most 0.5 (outlines); worst block 20.000 at 32,0, at most 9 (hands)");
  EXPECT_THAT(excess_text(judge(difference, {.share = DifferenceLimit{0.1, "leaves"}})),
              HasSubstr("16 steps 50.00%, at most 10.00% (leaves)"));
}

}  // namespace
}  // namespace throng::app::compare_test
