#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace throng::render {

inline constexpr std::size_t look_regions = 9;
inline constexpr float shade_reach = 0.35F;  ///< see AgentLook; shaders/agent_look.glsl repeats it

/// The parts of a surface that take a colour of an agent's look. A vertex of any other region keeps its own.
enum class Region : std::uint8_t { skin, hair, top, bottom, shoes, untinted, outer, headgear, thing };

constexpr std::size_t index_of(Region region) { return static_cast<std::size_t>(region); }

/// Says how the first and the second colour of a region share it.
enum class Pattern : std::uint8_t {
  plain,
  stripes_across,
  stripes_along,
  checks,
  tartan,
  dots,
  denim,
  print,  ///< on the chest
  trim,   ///< the second colour where the vertex says so
  blocks,
  flowers,
  camouflage,
  herringbone
};

/// Says how a region takes light.
enum class Fabric : std::uint8_t { cotton, denim, wool, satin, leather, nylon, skin, plastic };

/// Tells the shaders the constant data of an agent. `shaders/agent_look.glsl` repeats the layout (std430).
/// It is copied to the device when it changes, not in each frame.
///
///      0  tint of each region     RGB8, sRGB, red in the lowest byte; the highest byte has the pattern in bits 0-4 and
///                                 the fabric in bits 5-7
///     36  second of each region   RGB8, sRGB; the highest byte is the size of the pattern, 128 is the usual one
///     72  shape                   build (stout), frame (broad-shouldered), posture (stooped):
///                                 RGB8_SNORM in the low bytes
///     76  hair                    fullness and length: RG8_SNORM in the low bytes; 0 in both leaves the surface as
///                                 it is
///     80  shade                   outside of all regions: RGB8_SNORM in the low bytes; 1 makes linear red, green
///                                 or blue 1 + shade_reach times as bright, 0 leaves it as it is
///     84  face                    jaw (out), nose (forward), brow (forward and down), eyes (apart): RGBA8_SNORM
struct AgentLook {
  std::array<std::uint32_t, look_regions> tints;
  std::array<std::uint32_t, look_regions> seconds;
  std::uint32_t shape;
  std::uint32_t hair;
  std::uint32_t shade;
  std::uint32_t face;

  friend bool operator==(const AgentLook&, const AgentLook&) = default;
};
static_assert(sizeof(AgentLook) == 88);
static_assert(offsetof(AgentLook, seconds) == 36);
static_assert(offsetof(AgentLook, shape) == 72);
static_assert(offsetof(AgentLook, hair) == 76);
static_assert(offsetof(AgentLook, shade) == 80);
static_assert(offsetof(AgentLook, face) == 84);

inline constexpr std::uint32_t usual_pattern_size = 128;

/// Returns a tint that shows `color` (sRGB, red in the lowest byte; its highest byte is ignored).
constexpr std::uint32_t tint_of(std::uint32_t color, Pattern pattern = Pattern::plain, Fabric fabric = Fabric::cotton) {
  return (color & 0xFFFFFFU) | static_cast<std::uint32_t>(pattern) << 24U | static_cast<std::uint32_t>(fabric) << 29U;
}
/// Returns the second colour of a region with the size of its pattern, 1 to 255.
constexpr std::uint32_t second_of(std::uint32_t color, std::uint32_t pattern_size = usual_pattern_size) {
  return (color & 0xFFFFFFU) | pattern_size << 24U;
}

/// Returns a look in which nothing differs from how the surface was made.
constexpr AgentLook plain_look() {
  AgentLook look{};
  look.tints.fill(tint_of(0xFFFFFF));
  look.seconds.fill(second_of(0xFFFFFF));
  return look;
}

/// Returns a number for CrowdFrame::looks_number that none had before.
std::uint64_t new_looks_number();

/// Names the pieces of a character's mesh that an agent wears, and the piece that stands for all of them far away.
/// It is read on the processor alone.
struct Outfit {
  static constexpr std::size_t most_pieces = 18;
  static constexpr std::uint16_t no_piece = UINT16_MAX;

  std::array<std::uint16_t, most_pieces> pieces{};  ///< ascending
  std::uint16_t silhouette = no_piece;              ///< without one, the pieces are drawn far away too
  std::uint16_t count = 0;

  friend bool operator==(const Outfit&, const Outfit&) = default;
};
static_assert(sizeof(Outfit) == 40);

}  // namespace throng::render
