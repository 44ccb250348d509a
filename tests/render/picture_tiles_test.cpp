#include "engine/render/frame/picture_tiles.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "throng/render/camera.h"

namespace throng::render::picture_tiles_test {
namespace {

constexpr std::uint64_t gigabyte = 1'000'000'000;

TEST(PictureTiles, OfAPictureThatFitsAreOne) {
  const PictureTiles tiles({101, 57}, {4096, 4096});
  ASSERT_EQ(tiles.count(), 1);
  EXPECT_EQ(tiles.drawn(0), (PixelRect{{0, 0}, {101, 57}}));
  EXPECT_EQ(tiles.shown(0), tiles.drawn(0));
}

TEST(PictureTiles, ShowEveryPixelOnceAndBeginAtEvenOnes) {
  for (const glm::ivec2 picture :
       {glm::ivec2(300, 200), glm::ivec2(257, 129), glm::ivec2(1, 999), glm::ivec2(64, 65)}) {
    for (const int longest : {2, 63, 64, 100}) {
      const PictureTiles tiles(picture, glm::ivec2(longest));
      std::vector<int> times(static_cast<std::size_t>(picture.x) * static_cast<std::size_t>(picture.y), 0);
      for (int tile = 0; tile < tiles.count(); ++tile) {
        EXPECT_LE(tiles.drawn(tile).size.x, longest);
        EXPECT_LE(tiles.drawn(tile).size.y, longest);
        const auto [corner, size] = tiles.shown(tile);
        EXPECT_EQ(corner.x % 2 + corner.y % 2, 0);
        for (int y = corner.y; y < corner.y + size.y; ++y) {
          for (int x = corner.x; x < corner.x + size.x; ++x) ++times[static_cast<std::size_t>(y * picture.x + x)];
        }
      }
      EXPECT_EQ(times, std::vector<int>(times.size(), 1)) << picture.x << 'x' << picture.y << ' ' << longest;
    }
  }
}

// A point that is at pixel (x, y) of the whole is at (x, y) from the corner of the tile.
TEST(PictureTiles, SeeTheirPartOfTheView) {
  const glm::ivec2 picture(300, 200);
  const CameraView whole = view_of(Camera(), 1.5F);
  const auto pixel = [](const CameraView& view, glm::ivec2 size) {
    const glm::vec4 clip = view.projection * view.view * glm::vec4(0.3F, 1.2F, -2.0F, 1.0F);
    return (glm::vec2(clip) / clip.w + 1.0F) * 0.5F * glm::vec2(size);
  };
  const PictureTiles tiles(picture, {128, 128});
  for (int tile = 0; tile < tiles.count(); ++tile) {
    const PixelRect drawn = tiles.drawn(tile);
    const glm::vec2 in_tile = pixel(part_of(whole, picture, drawn), drawn.size) + glm::vec2(drawn.corner);
    EXPECT_NEAR(in_tile.x, pixel(whole, picture).x, 1e-3);
    EXPECT_NEAR(in_tile.y, pixel(whole, picture).y, 1e-3);
  }
}

TEST(PictureTiles, HaveTheDividerOfASplitPictureWhereItIs) {
  const SplitView part = part_of(SplitView{.divider = 0.5F}, {300, 200}, {{100, 0}, {100, 100}});
  EXPECT_FLOAT_EQ(part.divider, 0.5F);
  EXPECT_LT(part_of(SplitView{.divider = 0.25F}, {300, 200}, {{100, 0}, {100, 100}}).divider, 0.0F);
}

TEST(PlannedTiles, GetSmallerUntilMemoryHoldsThem) {
  const TileLimits plenty{.longest = {4096, 4096}, .memory = 10 * gigabyte, .bytes_a_pixel = 100};
  EXPECT_EQ(plan_tiles({12000, 12000}, plenty)->tile_size(), glm::ivec2(4000, 4000));
  TileLimits scarce = plenty;
  scarce.memory = gigabyte;
  EXPECT_EQ(plan_tiles({12000, 12000}, scarce)->tile_size(), glm::ivec2(2000, 2000));
}

TEST(PlannedTiles, OfAPictureOfOneColumnGetShorterOnly) {
  const TileLimits limits{.longest = {4096, 4096}, .memory = 60'000, .bytes_a_pixel = 100};
  EXPECT_EQ(plan_tiles({1, 4000}, limits)->tile_size(), glm::ivec2(1, 250));
}

TEST(PlannedTiles, OnADeviceWithMemoryOfItsOwnAreAsLargeAsItTakes) {
  const TileLimits limits{.longest = {8192, 4096}, .memory = gigabyte};
  EXPECT_EQ(plan_tiles({12000, 12000}, limits)->tile_size(), glm::ivec2(6000, 4000));
}

TEST(PlannedTiles, OfAPictureThatMemoryDoesNotHoldAreRefusedWithTheLargestThatItDoes) {
  const TileLimits limits{.longest = {4096, 4096}, .memory = gigabyte, .bytes_a_pixel = 100};
  const Result<PictureTiles> tiles = plan_tiles({20000, 20000}, limits);
  ASSERT_FALSE(tiles);
  EXPECT_EQ(
      tiles.error().message.find("a picture of 20000x20000 pixels takes 1.5 GiB of memory, and 954 MiB are left; the "
                                 "largest of its shape is 157"),
      0U)
      << tiles.error().message;
}

TEST(PlannedTiles, LeaveRoomForWhatIsKeptBesideThePicture) {
  TileLimits limits{.longest = {4096, 4096}, .memory = gigabyte, .bytes_a_pixel = 30};
  EXPECT_TRUE(plan_tiles({8000, 8000}, limits));
  limits.bytes_beside = 16;
  EXPECT_FALSE(plan_tiles({8000, 8000}, limits)) << "64 megapixels take 16 bytes more each";
}

TEST(PlannedTiles, OfAWindowAreOneOrRefused) {
  TileLimits limits{.longest = {4096, 4096}, .memory = 2 * gigabyte, .bytes_a_pixel = 30, .whole = true};
  EXPECT_EQ(plan_tiles({7680, 4320}, limits)->count(), 1);
  limits.memory = gigabyte;
  EXPECT_FALSE(plan_tiles({7680, 4320}, limits));
}

TEST(PlannedTiles, OfTheLargestThatIsNamedAreMade) {
  const TileLimits limits{.longest = {4096, 4096}, .memory = gigabyte, .bytes_a_pixel = 100};
  const std::string words = plan_tiles({32000, 16000}, limits).error().message;
  const std::size_t cross = words.rfind('x');
  const int wide = std::stoi(words.substr(words.rfind(' ') + 1)), high = std::stoi(words.substr(cross + 1));
  EXPECT_TRUE(plan_tiles({wide, high}, limits));
  EXPECT_FALSE(plan_tiles({wide + 8, high + 8}, limits));
}

}  // namespace
}  // namespace throng::render::picture_tiles_test
