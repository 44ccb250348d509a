#pragma once

#include <array>
#include <cstdint>

#include "app/crowd/random.h"
#include "engine/render/instance_record.h"

namespace throng::app {

/// The colours of the tint regions (skin, hair, shirt, trousers, shoes): RGBA8, sRGB, red in the lowest byte, alpha
/// 255.
using Tints = std::array<std::uint32_t, render::tint_regions>;

/// Draws the clothes, hair and skin of one person: muted colours for most, an accent here and there.
Tints random_tints(Random& random);

/// The shape of one body, each value from -1 to 1; all 0 is the character as it was made. A character whose file has no
/// `_SHAPE` and `_HAIR` shows none of it.
struct Variant {
  float build = 0.0F;     ///< slim to stout
  float frame = 0.0F;     ///< broad hips to broad shoulders
  float posture = 0.0F;   ///< upright to stooped
  float fullness = 0.0F;  ///< cropped hair to full hair
  float length = 0.0F;    ///< short hair to long hair

  std::uint32_t shape() const;  ///< InstanceRecord::shape
  std::uint32_t hair() const;   ///< InstanceRecord::hair

  friend bool operator==(const Variant&, const Variant&) = default;
};

/// Draws a woman or a man of any build; most are near the middle.
Variant random_variant(Random& random);

/// Draws InstanceRecord::shade for colours that are a file's own: up to 10% lighter or darker and 4% warmer or cooler,
/// as the screen counts, so that they stay what they are.
std::uint32_t random_shade(Random& random);

/// Draws the height over that of the file, of people as they differ: 4% in standard deviation, 10% at most.
float random_size(Random& random);

}  // namespace throng::app
