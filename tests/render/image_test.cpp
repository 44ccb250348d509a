#include "throng/render/image.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

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
  EXPECT_NE(noise.error().message.find("noise.png: it is no PNG"), std::string::npos);
}

TEST_F(ImageFile, IsRefusedByItsHeaderWhereItWouldFillTheMemory) {
  constexpr std::string_view of_60000_by_60000(
      "\x89\x50\x4E\x47\x0D\x0A\x1A\x0A\x00\x00\x00\x0D\x49\x48\x44\x52\x00\x00\xEA\x60\x00\x00\xEA\x60"
      "\x08\x06\x00\x00\x00\x80\xD2\x75\x42\x00\x00\x00\x0B\x49\x44\x41\x54\x78\x9C\x63\x60\x80\x01\x00"
      "\x00\x0A\x00\x01\x7F\x80\x74\x5E",
      56);
  std::ofstream(folder_ / "bomb.png", std::ios::binary) << of_60000_by_60000;
  const Result<Image> bomb = read_png(folder_ / "bomb.png");
  ASSERT_FALSE(bomb);
  EXPECT_NE(bomb.error().message.find("it is 60000 by 60000 pixels by its header"), std::string::npos);
}

TEST_F(ImageFile, SaysWhatItWasToldToSay) {
  const std::vector<PngText> texts{{"Software", "Throng 1.0.0"}, {"Throng context", "egl"}};
  ASSERT_TRUE(write_png(gradient(40, 23), folder_ / "picture.png", texts));
  const auto read = read_png_texts(folder_ / "picture.png");
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, texts);
  EXPECT_EQ(read_png(folder_ / "picture.png")->rgba, gradient(40, 23).rgba);
}

TEST_F(ImageFile, WithoutTextsSaysNothing) {
  ASSERT_TRUE(write_png(gradient(8, 8), folder_ / "picture.png"));
  const auto read = read_png_texts(folder_ / "picture.png");
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->empty());
}

// Wherever a file is cut, its texts are those before the cut, and it is no picture any more.
TEST_F(ImageFile, ThatIsCutSaysNoMoreThanIsThere) {
  const std::vector<PngText> texts{{"Software", "Throng"}};
  ASSERT_TRUE(write_png(gradient(8, 8), folder_ / "picture.png", texts));
  constexpr std::uintmax_t end_bytes = 12;  // without the last chunk, all pixels are there
  const std::uintmax_t whole = std::filesystem::file_size(folder_ / "picture.png");
  for (std::uintmax_t left = whole; left-- > 0;) {
    std::filesystem::resize_file(folder_ / "picture.png", left);
    const auto read = read_png_texts(folder_ / "picture.png");
    EXPECT_EQ(static_cast<bool>(read), left >= 8) << left;
    EXPECT_TRUE(!read || read->empty() || *read == texts) << left;
    EXPECT_TRUE(left >= whole - end_bytes || !read_png(folder_ / "picture.png")) << left;
  }
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
  const Result<NumberImage> read = read_any_png(folder_ / "numbers.png");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->channels, 1);
  EXPECT_EQ(read->width, 31);
  EXPECT_EQ(read->height, 17);
  EXPECT_EQ(read->numbers, written.numbers);
  EXPECT_EQ(*read->pixel(2, 1), 33 * 257);
}

TEST_F(ImageFile, OfColoursWith16BitsIsReadToTheLastBit) {
  NumberImage written = in_16_bits(gradient(9, 7));
  written.numbers[5] = 12345;
  ASSERT_TRUE(write_png(written, folder_ / "deep.png"));
  const Result<NumberImage> read = read_any_png(folder_ / "deep.png");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->channels, 4);
  EXPECT_EQ(read->numbers, written.numbers);
  EXPECT_EQ(read_png(folder_ / "deep.png")->rgba, in_8_bits(written).rgba) << "16 bits are sRGB as 8 are";
}

TEST_F(ImageFile, OfAPaletteOfGreyOrOfLinearColoursBecomesSrgbWithAlpha) {
  constexpr std::string_view palette(
      "\x89\x50\x4E\x47\x0D\x0A\x1A\x0A\x00\x00\x00\x0D\x49\x48\x44\x52\x00\x00\x00\x02\x00\x00\x00\x01"
      "\x01\x03\x00\x00\x00\xCE\xEC\xED\xC9\x00\x00\x00\x06\x50\x4C\x54\x45\x0A\x14\x1E\xC8\x64\x32\x77\xA0"
      "\xB3\x9C\x00\x00\x00\x02\x74\x52\x4E\x53\x00\x80\x9B\x2B\x4E\x18\x00\x00\x00\x0A\x49\x44\x41\x54\x78"
      "\xDA\x63\x70\x00\x00\x00\x42\x00\x41\x84\xBF\x8E\x62\x00\x00\x00\x00\x49\x45\x4E\x44\xAE\x42\x60\x82",
      99);
  constexpr std::string_view grey(
      "\x89\x50\x4E\x47\x0D\x0A\x1A\x0A\x00\x00\x00\x0D\x49\x48\x44\x52\x00\x00\x00\x02\x00\x00\x00\x01"
      "\x08\x00\x00\x00\x00\xD1\x49\x20\x56\x00\x00\x00\x0B\x49\x44\x41\x54\x78\xDA\x63\x60\xA8\x07\x00\x00"
      "\x82\x00\x80\xB3\xB6\x6E\xD1\x00\x00\x00\x00\x49\x45\x4E\x44\xAE\x42\x60\x82",
      68);
  constexpr std::string_view linear(
      "\x89\x50\x4E\x47\x0D\x0A\x1A\x0A\x00\x00\x00\x0D\x49\x48\x44\x52\x00\x00\x00\x01\x00\x00\x00\x01"
      "\x08\x02\x00\x00\x00\x90\x77\x53\xDE\x00\x00\x00\x04\x67\x41\x4D\x41\x00\x01\x86\xA0\x31\xE8\x96\x5F"
      "\x00\x00\x00\x0C\x49\x44\x41\x54\x78\xDA\x63\x30\x67\xF8\x0F\x00\x01\xA8\x01\x37\x23\x73\x4E\xA1\x00"
      "\x00\x00\x00\x49\x45\x4E\x44\xAE\x42\x60\x82",
      85);
  const auto pixels = [&](std::string_view bytes) {
    std::ofstream(folder_ / "other.png", std::ios::binary) << bytes;
    const Result<Image> read = read_png(folder_ / "other.png");
    return read ? std::vector<int>(read->rgba.begin(), read->rgba.end()) : std::vector<int>();
  };
  EXPECT_EQ(pixels(palette), (std::vector{10, 20, 30, 0, 200, 100, 50, 128}));
  EXPECT_EQ(pixels(grey), (std::vector{0, 0, 0, 255, 127, 127, 127, 255}));
  const std::vector<int> of_linear = pixels(linear);
  ASSERT_EQ(of_linear.size(), 4U);
  EXPECT_NEAR(of_linear[0], 128, 3) << "0.216 of the light";
  EXPECT_EQ(of_linear[1], 0);
  EXPECT_EQ(of_linear[2], 255);
}

TEST_F(ImageFile, OfNumbersIsReadInAllPiecesOrNot) {
  ASSERT_TRUE(write_png(slope(31, 17), folder_ / "numbers.png"));
  std::filesystem::resize_file(folder_ / "numbers.png", 60);
  const Result<NumberImage> read = read_any_png(folder_ / "numbers.png");
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
