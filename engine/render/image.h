#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "engine/render/png_text.h"
#include "engine/result.h"

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

/// A picture of whole numbers from 0 to 65535, one a pixel; top row first.
struct NumberImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> numbers;  ///< width * height

  std::uint16_t at(int x, int y) const {
    return numbers[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

Result<Image> read_png(const std::filesystem::path& file);
/// Reads a grey PNG of 16 bits, as write_png() writes it.
Result<NumberImage> read_number_png(const std::filesystem::path& file);

/// Returns whether a file is a PNG of that size from its first byte to its last; what lies between is not looked at.
bool is_whole_png(const std::filesystem::path& file, int width, int height);

/// Writes the picture as a PNG that says `texts` of itself. `file` is whole or as it was.
Status write_png(const Image& image, const std::filesystem::path& file, std::span<const PngText> texts = {});
/// Writes numbers as a grey PNG of 16 bits.
Status write_png(const NumberImage& image, const std::filesystem::path& file);

}  // namespace throng::render
