// Patterns and fabrics of pieces that agents wear, on a flat sheet.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/gl/gl_test.h"
#include "tests/gl/sheet.h"

namespace throng::render::test::patterns_test {
namespace {

constexpr std::uint32_t black = 0x000000, white = 0xFFFFFF;
constexpr int pattern_count = 13;

class Patterns : public SheetTest {
 protected:
  /// Returns the green of all pixels of the middle of a sheet of so many metres, black and white.
  std::vector<int> greens(Pattern pattern, float metres, Fabric fabric = Fabric::cotton) {
    sheet().dress(tint_of(black, pattern, fabric), second_of(white));
    sheet().lay_out(metres);
    const Image image = sheet().picture();
    std::vector<int> found;
    for (int y = image.height / 4; y < image.height * 3 / 4; ++y) {
      for (int x = image.width * 3 / 8; x < image.width * 5 / 8; ++x) found.push_back(image.pixel(x, y)[1]);
    }
    return found;
  }
  static double mean(const std::vector<int>& values) {
    double sum = 0;
    for (const int value : values) sum += value;
    return sum / static_cast<double>(values.size());
  }
  static int spread(const std::vector<int>& values) {
    const auto [low, high] = std::ranges::minmax(values);
    return high - low;
  }
};

TEST_F(Patterns, ShowBothColoursFromNearAndTheirMeanFromAfar) {
  const int plain = spread(greens(Pattern::plain, 0.5F));
  EXPECT_LT(plain, 12);
  for (int number = 1; number < pattern_count; ++number) {
    const auto pattern = static_cast<Pattern>(number);
    if (pattern == Pattern::print || pattern == Pattern::trim || pattern == Pattern::blocks) continue;
    if (pattern != Pattern::denim) {
      EXPECT_GT(spread(greens(pattern, 0.5F)), 90) << number;
    }
    EXPECT_LT(spread(greens(pattern, 400.0F)), 16) << number << " is too small to be seen";
  }
}

TEST_F(Patterns, DoNotChangeTheirBrightnessWhereTheDressedProgramEnds) {
  for (int number = 0; number < pattern_count; ++number) {
    const auto pattern = static_cast<Pattern>(number);
    if (pattern == Pattern::print || pattern == Pattern::trim || pattern == Pattern::blocks) continue;
    sheet().mesh_lod = 0;
    const double near = mean(greens(pattern, 400.0F));
    sheet().mesh_lod = first_silhouette_lod;
    const double far = mean(greens(pattern, 400.0F));
    EXPECT_NEAR(near, far, 20.0) << number;
  }
}

TEST_F(Patterns, OfStripesLieAcrossOrAlong) {
  const auto change_along = [](const Image& image, int dx, int dy) {
    int most = 0;
    const auto green = [&](int i) { return int{image.pixel(image.width / 2 + dx * i, image.height / 2 + dy * i)[1]}; };
    for (int i = 1; i < image.height / 4; ++i) most = std::max(most, std::abs(green(i) - green(0)));
    return most;
  };
  sheet().lay_out(0.4F);
  sheet().dress(tint_of(black, Pattern::stripes_across), second_of(white));
  const Image across = sheet().picture();
  sheet().dress(tint_of(black, Pattern::stripes_along), second_of(white));
  const Image along = sheet().picture();
  EXPECT_LT(change_along(across, 1, 0), 20);
  EXPECT_GT(change_along(across, 0, 1), 90);
  EXPECT_GT(change_along(along, 1, 0), 90);
  EXPECT_LT(change_along(along, 0, 1), 20);
}

TEST_F(Patterns, OfTrimHaveTheSecondColourWhereTheVertexSaysSo) {
  sheet().trims = {0, 1, 0, 1};  // the right half
  sheet().dress(tint_of(black, Pattern::trim), second_of(white));
  const Image image = sheet().picture();
  EXPECT_GT(Sheet::brightness(image, 0.60F, 0.5F), Sheet::brightness(image, 0.40F, 0.5F) + 90.0);
  EXPECT_NEAR(Sheet::brightness(image, 0.40F, 0.5F), Sheet::brightness(image, 0.45F, 0.5F), 8.0) << "a sharp edge";
}

TEST_F(Patterns, OfBlocksBeginAtTheWaist) {
  sheet().dress(tint_of(black, Pattern::blocks), second_of(white));
  sheet().coords = {0, 1.4F, 0.4F, 1.4F, 0, 1.0F, 0.4F, 1.0F};
  const Image image = sheet().picture();
  EXPECT_GT(Sheet::brightness(image, 0.5F, 0.35F), Sheet::brightness(image, 0.5F, 0.65F) + 90.0);
}

TEST_F(Patterns, OfAPrintLieOnTheMiddleOfTheChest) {
  sheet().dress(tint_of(black, Pattern::print), second_of(white));
  sheet().coords = {-1.0F, 2.3F, 1.0F, 2.3F, -1.0F, 0.3F, 1.0F, 0.3F};
  const Image image = sheet().picture();
  int brightest = 0, at_edge = 0;
  for (int i = -image.height / 8; i < image.height / 8; ++i) {
    brightest = std::max<int>(brightest, image.pixel(image.width / 2 + i, image.height / 2)[1]);
  }
  at_edge = image.pixel(image.width / 2, image.height / 2 - image.height * 23 / 100)[1];
  EXPECT_GT(brightest, at_edge + 90);
}

TEST_F(Patterns, GrowWithTheirSize) {
  const auto edges = [&](std::uint32_t size) {
    sheet().dress(tint_of(black, Pattern::stripes_across), second_of(white, size));
    sheet().lay_out(2.0F);
    const Image image = sheet().picture();
    int count = 0;
    const auto is_white = [&](int y) { return image.pixel(image.width / 2, y)[1] > 100; };
    for (int y = image.height / 4 + 1; y < image.height * 3 / 4; ++y) count += is_white(y) != is_white(y - 1) ? 1 : 0;
    return count;
  };
  EXPECT_NEAR(edges(128), 2 * edges(255), 4);
}

TEST_F(Patterns, OfSatinMirrorTheSunAndThoseOfWoolDoNot) {
  sheet().light.sun_elevation = 5.0F;
  sheet().face({0, 0.1F, 1});
  const double cotton = mean(greens(Pattern::plain, 0.5F)), satin = mean(greens(Pattern::plain, 0.5F, Fabric::satin)),
               wool = mean(greens(Pattern::plain, 0.5F, Fabric::wool));
  EXPECT_GT(satin, cotton + 30.0);
  EXPECT_LT(wool, cotton + 15.0);
}

}  // namespace
}  // namespace throng::render::test::patterns_test
