// Holds pictures that are drawn in tiles against the same ones drawn whole.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "throng/render/image.h"

#include "app/show/show.h"
#include "app/window/demo.h"
#include "engine/render/frame/tiled_target.h"
#include "tests/gl/doll_crowd.h"
#include "tests/gl/gl_test.h"
#include "tests/gl/small_picture.h"

namespace throng::app::tiled_picture_test {
namespace {

using render::Image;

constexpr int width = 300, height = 200, tile = 128;

/// The share of pixels of which a channel differs by more than `steps` of 255.
double share_of_other_pixels(const Image& whole, const Image& tiled, int steps = 2) {
  EXPECT_EQ(whole.width, tiled.width);
  EXPECT_EQ(whole.height, tiled.height);
  int others = 0;
  for (int y = 0; y < whole.height; ++y) {
    for (int x = 0; x < whole.width; ++x) {
      int most = 0;
      for (int channel = 0; channel < 4; ++channel) {
        most = std::max(most, std::abs(int{whole.pixel(x, y)[channel]} - int{tiled.pixel(x, y)[channel]}));
      }
      if (most > steps) ++others;
    }
  }
  return others / (static_cast<double>(whole.width) * whole.height);
}

/// The matrix of a tile rounds otherwise than that of the whole, by less than a 256th of a pixel. A pixel whose middle,
/// or whose sample, an outline just touches may then fall to the other side of it.
constexpr double most_other_pixels = 0.0002;

DemoOptions crowd_in_a_small_picture() {
  DemoOptions options = picture_by_processor(width, height);
  options.tuning.agents = 40;
  options.tuning.shadows = options.tuning.crowd_shade = options.tuning.scenery =
      false;  // where a map is read at the depth that it holds, rounding decides: see Shadows
  options.frames = 8;
  return options;
}

Image picture(DemoOptions options, int longest_tile) {
  options.longest_tile = longest_tile;
  options.screenshot = (std::filesystem::path(testing::TempDir()) / "throng_tiled.png").string();
  EXPECT_EQ(run_demo(options), 0);
  auto image = render::read_png(options.screenshot);
  EXPECT_TRUE(image);
  std::filesystem::remove(options.screenshot);
  return image ? std::move(*image) : Image::blank(width, height);
}

void expect_tiled_as_whole(const DemoOptions& options, int steps = 2) {
  const Image whole = picture(options, 4096), tiled = picture(options, tile);
  EXPECT_LE(share_of_other_pixels(whole, tiled, steps), most_other_pixels);
}

TEST(TiledPicture, OfACrowdOnAPlazaIsTheWholeOne) { expect_tiled_as_whole(crowd_in_a_small_picture()); }

TEST(TiledPicture, OfAnOddSizeAndOneSampleAPixelIsTheWholeOne) {
  DemoOptions options = crowd_in_a_small_picture();
  options.msaa = 0;
  options.width = 257;
  options.height = 129;
  expect_tiled_as_whole(options);
}

TEST(TiledPicture, OfFacesNearByIsTheWholeOne) {
  DemoOptions options = crowd_in_a_small_picture();
  options.tuning.scene = Scene::grid;
  options.tuning.agents = 9;
  options.camera_name = "close";
  expect_tiled_as_whole(options);
}

TEST(TiledPicture, WithLinesOverItIsTheWholeOne) {
  DemoOptions options = crowd_in_a_small_picture();
  options.tuning.inspection.thresholds = true;
  options.tuning.inspection.freeze_camera = true;
  options.tuning.lod.rule = LodRule::distance;
  options.camera_path = CameraPath::orbit;
  expect_tiled_as_whole(options);
}

TEST(TiledPicture, SplitByALineIsTheWholeOne) {
  DemoOptions options = crowd_in_a_small_picture();
  options.tuning.inspection = {.split = Split::shown, .split_at = 0.35F, .forced_interval = 16};
  expect_tiled_as_whole(options);
}

TEST(TiledPicture, OfADifferenceIsTheWholeOne) {
  DemoOptions options = crowd_in_a_small_picture();
  options.tuning.inspection = {.split = Split::difference, .split_at = 0.35F, .forced_interval = 16};
  expect_tiled_as_whole(options, 2 * 8);  // differences are shown eight times as bright
}

TEST(TiledPicture, WithTheOverlayIsTheWholeOne) {
  DemoOptions options = crowd_in_a_small_picture();
  options.width = 900;
  options.height = 500;
  options.ui = true;
  options.ui_fixed = true;
  expect_tiled_as_whole(options);
}

// The crowd is posed for the whole picture: were it for a tile, more would be skipped.
TEST(TiledPicture, HasTheLevelOfDetailOfTheWholeOne) {
  DemoOptions options = crowd_in_a_small_picture();
  options.tuning.debug_view = DebugView::interval;
  options.tuning.lod.rule = LodRule::budget;
  options.frames = 20;
  expect_tiled_as_whole(options);
}

TEST(TiledPicture, OfOnePixelIsDrawn) {
  DemoOptions options = crowd_in_a_small_picture();
  options.width = options.height = 1;
  EXPECT_EQ(picture(options, tile).rgba.size(), 4U);
}

}  // namespace
}  // namespace throng::app::tiled_picture_test

namespace throng::render::test::tiled_picture_test {
namespace {

using TiledDolls = SoftwareGlTest;

TEST_F(TiledDolls, ThatAreSeenThroughAreTheWholeOnes) {
  MaterialData glass;
  glass.base_color[3] = 0.6F;  // at 0.5, where shadows begin, rounding would decide
  glass.blended = true;
  const auto picture = [&](int longest_tile) {
    DollCrowd crowd(context(), 4, longest_tile);
    CrowdMeshData doll = crowd.doll().mesh_data();
    doll.materials = {glass};
    EXPECT_TRUE(crowd.renderer().load_characters(std::vector<CrowdMeshData>(2, doll)));
    crowd.stand(15);
    crowd.write_palettes();
    CrowdFrame frame = crowd.frame();
    frame.shadows = false;
    crowd.renderer().draw(frame);
    return crowd.renderer().read_image();
  };
  EXPECT_LE(app::tiled_picture_test::share_of_other_pixels(picture(4096), picture(64)),
            app::tiled_picture_test::most_other_pixels);
}

TEST_F(TiledDolls, AreDrawnInSmallerTilesWhereTheDeviceRefusesLarge) {
  const TileLimits limits{.longest = context().limits().target * 2, .memory = std::uint64_t{1} << 40U};
  const auto target = TiledTarget::create({context().limits().target.x + 2, 4}, 0, limits);
  ASSERT_TRUE(target) << target.error().message;
  EXPECT_TRUE(target->is_tiled());
  context().messages().clear();
}

TEST_F(TiledDolls, AreRefusedWholeWhereTheDeviceTakesNoSuchPicture) {
  const glm::ivec2 size = context().limits().target + glm::ivec2(1);
  const TileLimits limits{.longest = context().limits().target, .memory = std::uint64_t{1} << 40U, .whole = true};
  const auto target = TiledTarget::create(size, 4, limits);
  ASSERT_FALSE(target);
  EXPECT_NE(target.error().message.find("is larger than the graphics device takes"), std::string::npos);
}

TEST_F(TiledDolls, AreNotDrawnBlackWhereTheDeviceRefusesTheirPicture) {
  const auto target = ImageTarget::create({context().limits().target.x + 2, 4}, 4);
  ASSERT_FALSE(target);
  EXPECT_NE(target.error().message.find("the graphics device"), std::string::npos) << target.error().message;
  context().messages().clear();
}

TEST_F(TiledDolls, EndAPictureThatFailedInWords) {
  DollCrowd crowd(context());
  EXPECT_TRUE(crowd.renderer().finish());
  glBindBuffer(GL_ARRAY_BUFFER, 0xFFFFFF);  // no such buffer
  const Status finished = crowd.renderer().finish();
  ASSERT_FALSE(finished);
  EXPECT_NE(finished.error().message.find("the graphics device refuses a call for this picture"), std::string::npos);
  EXPECT_TRUE(crowd.renderer().finish()) << "it is told once";
  context().messages().clear();
}

}  // namespace
}  // namespace throng::render::test::tiled_picture_test
