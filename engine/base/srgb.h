#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace throng {

/// Turns a number of sRGB, 0 to 1, into light, and back (IEC 61966-2-1).
inline float light_of_srgb(float srgb) {
  return srgb <= 0.04045F ? srgb / 12.92F : std::pow((srgb + 0.055F) / 1.055F, 2.4F);
}
inline float srgb_of_light(float light) {
  return light <= 0.0031308F ? 12.92F * light : 1.055F * std::pow(light, 1.0F / 2.4F) - 0.055F;
}

/// Returns the light of each number of sRGB that a byte holds, of which 255 is 1.
inline const std::array<float, 256>& lights_of_srgb() {
  static const std::array<float, 256> lights = [] {
    std::array<float, 256> made{};
    for (std::size_t byte = 0; byte < made.size(); ++byte)
      made[byte] = light_of_srgb(static_cast<float>(byte) / 255.0F);
    return made;
  }();
  return lights;
}

/// Rounds a number to a byte, of which 255 is 1.
inline std::uint8_t to_byte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

}  // namespace throng
