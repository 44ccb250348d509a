#pragma once

#include "assets/places/arithmetic.h"
#include "assets/places/mesh_builder.h"

namespace throng::places::paints {

inline Paint matt(std::uint32_t hex) { return {.color = rgb(hex)}; }
inline Paint metal(std::uint32_t hex) { return {.color = rgb(hex), .kind = Kind::metal}; }
/// Follows the instance's tint.
inline Paint tinted(std::uint32_t hex) { return {.color = rgb(hex), .tinted = 255}; }
inline Paint cloth(std::uint32_t hex, int sway) { return {.color = rgb(hex), .sway = sway}; }

inline const Paint limestone = matt(0xD9CBB0);
inline const Paint pale_stone = matt(0xE6DCC8);
inline const Paint dark_stone = matt(0xA89C88);
inline const Paint granite = matt(0x8C8781);
inline const Paint stucco = tinted(0xE9D9BE);
inline const Paint brick = tinted(0xB5755A);
inline const Paint white_paint = matt(0xEFEAE0);
inline const Paint iron = metal(0x2B2E30);
inline const Paint steel = metal(0x9AA0A3);
inline const Paint timber = matt(0x8C6A4C);
inline const Paint roof_tile = matt(0xB0684A);
inline const Paint slate = matt(0x5E646B);
inline const Paint copper = matt(0x5F8474);
inline const Paint water{.color = rgb(0x3F6B73), .kind = Kind::water, .baked = false};

/// Glass of a window that is lit at night where `lit` is above 0.
inline Paint glass(int lit) {
  return {.color = lit > 0 ? rgb(0x8C7A5A) : rgb(0x39434B), .glow = lit, .kind = Kind::glass};
}
/// Behind a shop's window it is warm, and dark by day.
inline const Paint shop_glass{.color = rgb(0x6A583C), .glow = 255, .kind = Kind::glass};
/// Below the lamps of a room or shop it is darker.
inline Paint dimmed(Paint glass, double share) {
  glass.glow = static_cast<int>(glass.glow * share);
  glass.color *= 0.7 + 0.3 * share;
  return glass;
}

/// A lamp's glass.
inline const Paint lantern{.color = rgb(0xFFE7B8), .glow = 255, .baked = false};

}  // namespace throng::places::paints
