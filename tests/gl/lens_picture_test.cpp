// Stills through a lens: --focus and --aperture.
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "throng/render/image.h"

#include "app/window/demo.h"
#include "tests/gl/small_picture.h"

namespace throng::app::lens_picture_test {
namespace {

using render::Image;

DemoOptions still() {
  DemoOptions options = picture_by_processor(200, 120);
  options.tuning.agents = 40;
  options.frames = 4;
  return options;
}

Image picture(DemoOptions options) {
  options.screenshot = (std::filesystem::path(testing::TempDir()) / "throng_lens.png").string();
  EXPECT_EQ(run_demo(options), 0);
  auto image = render::read_png(options.screenshot);
  EXPECT_TRUE(image);
  std::filesystem::remove(options.screenshot);
  return image ? std::move(*image) : Image::blank(options.width, options.height);
}

DemoOptions focused(float metres, float aperture) {
  DemoOptions options = still();
  options.focus = metres;
  options.aperture = aperture;
  return options;
}

/// The mean difference of neighbours in a row, of 255: a blurred picture has less of it.
double sharpness(const Image& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 1; x < image.width; ++x) sum += std::abs(int{image.pixel(x, y)[1]} - int{image.pixel(x - 1, y)[1]});
  }
  return sum / (static_cast<double>(image.width) * image.height);
}

double mean_difference(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(int{a.rgba[i]} - int{b.rgba[i]});
  return sum / static_cast<double>(a.rgba.size());
}

TEST(LensPicture, IsTheSharpOneThroughAPinhole) {
  EXPECT_LT(mean_difference(picture(still()), picture(focused(8.0F, 64.0F))), 0.7);
}

TEST(LensPicture, IsBlurredThroughAWideLens) {
  const Image sharp = picture(still()), blurred = picture(focused(4.0F, 0.15F));
  EXPECT_LT(sharpness(blurred), 0.75 * sharpness(sharp));
  EXPECT_GT(mean_difference(sharp, blurred), 2.0);
}

TEST(LensPicture, IsTheSameInTiles) {
  DemoOptions options = focused(4.0F, 0.5F);
  const Image whole = picture(options);
  options.longest_tile = 64;
  EXPECT_LT(mean_difference(whole, picture(options)), 0.1);
}

}  // namespace
}  // namespace throng::app::lens_picture_test
