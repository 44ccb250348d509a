#include "app/people/wardrobe/distinct_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "app/people/crowd/character_look.h"

namespace throng::app {
namespace {

float channel(std::uint32_t color, unsigned shift) { return static_cast<float>(color >> shift & 0xFFU); }

bool is_near(std::uint32_t one, float one_lightness, std::uint32_t other, float other_lightness) {
  constexpr float most_apart = 12.0F;  // of 255, in one channel
  return std::ranges::all_of(std::array{0U, 8U, 16U}, [&](unsigned shift) {
    return std::abs(channel(one, shift) * one_lightness - channel(other, shift) * other_lightness) <= most_apart;
  });
}

/// Says whether two colours can fade until people do not tell them apart.
bool are_alike(std::uint32_t one, std::uint32_t other) {
  constexpr int steps = 16;
  const auto lightness = [](int step) {
    return least_lightness + (most_lightness - least_lightness) * static_cast<float>(step) / static_cast<float>(steps);
  };
  for (int step = 0; step <= steps; ++step) {
    for (int other_step = 0; other_step <= steps; ++other_step) {
      if (is_near(one, lightness(step), other, lightness(other_step))) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::uint32_t> distinct_colors(const Palette& palette) {
  std::vector<std::uint32_t> seen = palette.colors;
  for (std::size_t one = 0; one < seen.size(); ++one) {
    for (std::size_t other = 0; other < one; ++other) {
      if (seen[one] == seen[other] || !are_alike(palette.colors[one], palette.colors[other])) continue;
      const std::uint32_t joined = seen[one];
      std::ranges::replace(seen, joined, seen[other]);
    }
  }
  return seen;
}

}  // namespace throng::app
