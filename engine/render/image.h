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

Result<Image> read_png(const std::filesystem::path& file);

/// Writes the picture as a PNG that says `texts` of itself. `file` is whole or as it was.
Status write_png(const Image& image, const std::filesystem::path& file, std::span<const PngText> texts = {});

}  // namespace throng::render
