#include "engine/render/mesh/mip_levels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "engine/base/srgb.h"

namespace throng::render {
namespace {

constexpr std::size_t channels = 4;

/// Turns means of light into sRGB by a table whose steps are below one of sRGB.
std::uint8_t srgb_byte(float light) {
  static const auto bytes = [] {
    std::array<std::uint8_t, 8192> made{};
    for (std::size_t i = 0; i < made.size(); ++i) {
      made[i] = to_byte(srgb_of_light(static_cast<float>(i) / static_cast<float>(made.size() - 1)));
    }
    return made;
  }();
  return bytes[static_cast<std::size_t>(light * static_cast<float>(bytes.size() - 1) + 0.5F)];
}

/// The bytes of one channel in the four pixels that become one.
using Four = std::array<std::uint8_t, 4>;

std::uint8_t mean_of_numbers(const Four& four) {
  return static_cast<std::uint8_t>((four[0] + four[1] + four[2] + four[3] + 2) / 4);
}

std::uint8_t mean_of_colors(const Four& four) {
  const auto& lights = lights_of_srgb();
  return srgb_byte((lights[four[0]] + lights[four[1]] + lights[four[2]] + lights[four[3]]) / 4.0F);
}

std::vector<std::uint8_t> half_of(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height,
                                  ImageKind kind) {
  const std::size_t half_width = std::max<std::size_t>(width / 2, 1),
                    half_height = std::max<std::size_t>(height / 2, 1);
  std::vector<std::uint8_t> half(half_width * half_height * channels);
  auto out = half.begin();
  for (std::size_t y = 0; y < half_height; ++y) {
    const std::size_t upper = 2 * y * width, lower = std::min(2 * y + 1, height - 1) * width;
    for (std::size_t x = 0; x < half_width; ++x) {
      const std::size_t left = 2 * x, right = std::min(2 * x + 1, width - 1);
      for (std::size_t channel = 0; channel < channels; ++channel) {
        const auto at = [&](std::size_t pixel) { return pixels[pixel * channels + channel]; };
        const Four four{at(upper + left), at(upper + right), at(lower + left), at(lower + right)};
        const bool is_light = kind == ImageKind::colors && channel < 3;  // alpha is a number
        *out++ = is_light ? mean_of_colors(four) : mean_of_numbers(four);
      }
    }
  }
  return half;
}

}  // namespace

std::vector<std::vector<std::uint8_t>> mip_levels(const ImageData& image, ImageKind kind) {
  std::vector<std::vector<std::uint8_t>> levels;
  auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  std::span<const std::uint8_t> before = image.rgba;
  while (width > 1 || height > 1) {
    levels.push_back(half_of(before, width, height, kind));
    width = std::max<std::size_t>(width / 2, 1);
    height = std::max<std::size_t>(height / 2, 1);
    before = levels.back();
  }
  return levels;
}

}  // namespace throng::render
