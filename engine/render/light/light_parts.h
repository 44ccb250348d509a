#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace throng::render {

/// The parts of the light that a picture may have beside sun and sky, as bits for ProgramVariants.
enum LightPart : std::uint32_t { shadow_part = 1, crowd_shade_part = 2, lamp_part = 4 };
inline constexpr std::size_t light_part_count = 3;

/// Returns the switches of shaders/shadows.glsl and shaders/lamps.glsl, in the order of the bits, and `more` after
/// them.
inline std::vector<std::string> light_switches(std::vector<std::string> more = {}) {
  std::vector<std::string> all{"SHADOWS", "CROWD_SHADE", "LAMPS"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace throng::render
