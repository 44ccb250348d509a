#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "throng/render/png_text.h"
#include "throng/result.h"

namespace throng::render {

/// A picture in 8-bit sRGB with straight alpha: red, green, blue, alpha; top row first.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< width * height * 4

  static Image blank(int width, int height);
  std::uint8_t* pixel(int x, int y) { return rgba.data() + offset(x, y); }
  const std::uint8_t* pixel(int x, int y) const { return rgba.data() + offset(x, y); }

 private:
  std::size_t offset(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 4;
  }
};

/// A picture of whole numbers from 0 to 65535; top row first. A pixel has one, which is no colour, or four: red, green,
/// blue and straight alpha in sRGB.
struct NumberImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> numbers;  ///< width * height * channels
  int channels = 1;

  std::uint16_t* pixel(int x, int y) { return numbers.data() + offset(x, y); }
  const std::uint16_t* pixel(int x, int y) const { return numbers.data() + offset(x, y); }

 private:
  std::size_t offset(int x, int y) const {
    const auto place = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    return place * static_cast<std::size_t>(channels);
  }
};

/// Reads all that a PNG says of its pixels: one number of each from a grey PNG of 16 bits that names no colour space,
/// as write_png() writes numbers, and four from any other. Errors: it cannot be read, it is no PNG, or it has more than
/// 16,384 by 16,384 pixels.
Result<NumberImage> read_any_png(const std::filesystem::path& file);
/// Reads the colours of a PNG, rounded to 8 bits; one number a pixel is grey.
Result<Image> read_png(const std::filesystem::path& file);

/// A step of 8 bits is so many steps of 16: 255 is 65535.
inline constexpr int deep_steps = 257;

/// Returns colours with 16 bits a channel, and back, rounded. One number a pixel becomes grey.
NumberImage in_16_bits(const Image& image);
Image in_8_bits(const NumberImage& image);

/// Returns whether a file is a PNG of that size from its first byte to its last; it skips the bytes in between.
bool is_whole_png(const std::filesystem::path& file, int width, int height);

/// Writes the picture as a PNG that says `texts` of itself. `file` is whole or as it was.
Status write_png(const Image& image, const std::filesystem::path& file, std::span<const PngText> texts = {});
/// Writes numbers with 16 bits each: a grey PNG, or one with colours and alpha.
Status write_png(const NumberImage& image, const std::filesystem::path& file, std::span<const PngText> texts = {});

}  // namespace throng::render
