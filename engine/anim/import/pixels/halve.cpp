#include "engine/anim/import/pixels/halve.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace throng::import {

anim::Image halved(const anim::Image& image) {
  constexpr std::size_t channels = 4;
  const int width = (image.width + 1) / 2, height = (image.height + 1) / 2;
  const auto pixels = std::make_shared<std::vector<std::uint8_t>>();
  pixels->reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * channels);
  const auto texel = [&](int x, int y) {
    const auto row = static_cast<std::size_t>(std::min(y, image.height - 1));
    const auto column = static_cast<std::size_t>(std::min(x, image.width - 1));
    return image.rgba.subspan((row * static_cast<std::size_t>(image.width) + column) * channels, channels);
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto a = texel(2 * x, 2 * y), b = texel(2 * x + 1, 2 * y);
      const auto c = texel(2 * x, 2 * y + 1), d = texel(2 * x + 1, 2 * y + 1);
      for (std::size_t i = 0; i < channels; ++i) {
        pixels->push_back(static_cast<std::uint8_t>((a[i] + b[i] + c[i] + d[i] + 2) / 4));
      }
    }
  }
  return {.width = width, .height = height, .rgba = *pixels, .lender = pixels};
}

}  // namespace throng::import
