#include "engine/render/image.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/render/image_difference.h"

namespace throng::render::test::image_test {
namespace {

/// Gives the test a folder, and removes it at the end.
class ImageFile : public testing::Test {
 protected:
  ImageFile() {
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("throng_image_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  ~ImageFile() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

Image gradient(int width, int height) {
  Image image = Image::blank(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.pixel(x, y)[0] = static_cast<std::uint8_t>(x);
      image.pixel(x, y)[1] = static_cast<std::uint8_t>(y);
      image.pixel(x, y)[3] = static_cast<std::uint8_t>(255 - x);
    }
  }
  return image;
}

void paint_block(Image& image, int left, int top, std::uint8_t value) {
  for (int y = top; y < top + 16; ++y) {
    for (int x = left; x < left + 16; ++x) std::fill_n(image.pixel(x, y), 3, value);
  }
}

TEST_F(ImageFile, ComesBackAsItWasWritten) {
  const Image image = gradient(40, 23);
  ASSERT_TRUE(write_png(image, folder_ / "picture.png"));
  const Result<Image> read = read_png(folder_ / "picture.png");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->width, 40);
  EXPECT_EQ(read->height, 23);
  EXPECT_EQ(read->rgba, image.rgba);
}

TEST_F(ImageFile, LeavesNothingBesideIt) {
  ASSERT_TRUE(write_png(gradient(8, 8), folder_ / "picture.png"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(ImageFile, IsRefusedInAFolderThatIsNotThere) {
  const Status written = write_png(gradient(8, 8), folder_ / "absent" / "picture.png");
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message.find("absent/picture.png"), std::string::npos);
}

TEST_F(ImageFile, IsRefusedOverAFolderAndLeavesNothing) {
  std::filesystem::create_directories(folder_ / "picture.png" / "kept");
  ASSERT_FALSE(write_png(gradient(8, 8), folder_ / "picture.png"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "picture.png" / "kept"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(ImageFile, IsRefusedWhenAbsentOrNoise) {
  EXPECT_FALSE(read_png(folder_ / "absent.png"));
  std::ofstream(folder_ / "noise.png") << "this is no picture";
  const Result<Image> noise = read_png(folder_ / "noise.png");
  ASSERT_FALSE(noise);
  EXPECT_NE(noise.error().message.find("noise.png"), std::string::npos);
}

TEST(ImageDifference, OfEqualPicturesIsNothing) {
  const Result<ImageDifference> difference = compare(gradient(100, 50), gradient(100, 50));
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->mean, 0.0);
  EXPECT_EQ(difference->worst_block, 0.0);
}

TEST(ImageDifference, FindsTheOneBlockThatDiffers) {
  Image changed = Image::blank(640, 360);
  paint_block(changed, 320, 160, 55);
  const Result<ImageDifference> difference = compare(Image::blank(640, 360), changed);
  ASSERT_TRUE(difference);
  EXPECT_DOUBLE_EQ(difference->worst_block, 200.0);
  EXPECT_EQ(difference->worst_block_x, 320);
  EXPECT_EQ(difference->worst_block_y, 160);
  EXPECT_NEAR(difference->mean, 200.0 * 256 / (640 * 360), 1e-9);
}

TEST(ImageDifference, CountsBlocksThatTheEdgeCutsByTheirOwnSize) {
  Image changed = Image::blank(20, 20);
  for (int y = 16; y < 20; ++y) {
    for (int x = 16; x < 20; ++x) std::fill_n(changed.pixel(x, y), 3, std::uint8_t{155});
  }
  const Result<ImageDifference> difference = compare(Image::blank(20, 20), changed);
  ASSERT_TRUE(difference);
  EXPECT_DOUBLE_EQ(difference->worst_block, 100.0);
}

TEST(ImageDifference, IsRefusedForDifferentSizes) {
  const Result<ImageDifference> difference = compare(Image::blank(20, 20), Image::blank(20, 21));
  ASSERT_FALSE(difference);
  EXPECT_NE(difference.error().message.find("20x21"), std::string::npos);
}

NumberImage slope(int width, int height) {
  NumberImage image{width, height, {}};
  for (int place = 0; place < width * height; ++place) {
    image.numbers.push_back(static_cast<std::uint16_t>(place * 257));
  }
  return image;
}

TEST_F(ImageFile, OfNumbersIsReadAsItWasWritten) {
  const NumberImage written = slope(31, 17);
  ASSERT_TRUE(write_png(written, folder_ / "numbers.png"));
  const Result<NumberImage> read = read_number_png(folder_ / "numbers.png");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->width, 31);
  EXPECT_EQ(read->height, 17);
  EXPECT_EQ(read->numbers, written.numbers);
  EXPECT_EQ(read->at(2, 1), 33 * 257);
}

TEST_F(ImageFile, OfNumbersIsNoPictureAndNoPieceOfOne) {
  ASSERT_TRUE(write_png(gradient(9, 9), folder_ / "picture.png"));
  EXPECT_FALSE(read_number_png(folder_ / "picture.png"));
  ASSERT_TRUE(write_png(slope(31, 17), folder_ / "numbers.png"));
  std::filesystem::resize_file(folder_ / "numbers.png", 60);
  const Result<NumberImage> read = read_number_png(folder_ / "numbers.png");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("it ends too early"), std::string::npos) << read.error().message;
}

TEST_F(ImageFile, IsWholeInItsOwnSizeAndToItsLastByteAlone) {
  const std::filesystem::path file = folder_ / "picture.png";
  EXPECT_FALSE(is_whole_png(file, 9, 7));
  ASSERT_TRUE(write_png(gradient(9, 7), file));
  EXPECT_TRUE(is_whole_png(file, 9, 7));
  EXPECT_FALSE(is_whole_png(file, 7, 9));
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
  EXPECT_FALSE(is_whole_png(file, 9, 7));
  std::ofstream(file) << "no picture at all, but some bytes of text in its place";
  EXPECT_FALSE(is_whole_png(file, 9, 7));
}

}  // namespace
}  // namespace throng::render::test::image_test
