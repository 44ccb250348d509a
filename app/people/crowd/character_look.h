#pragma once

#include <array>
#include <cstdint>

#include "throng/render/agent_look.h"

#include "app/settings/settings.h"
#include "engine/base/random.h"

namespace throng::app {

/// The colours of skin, hair, shirt, trousers and shoes: RGBA8, sRGB, red in the lowest byte, alpha 255.
using Tints = std::array<std::uint32_t, 5>;

/// The most that agents differ in size, as a share, as they are drawn.
inline constexpr float usual_size_variety = 0.1F;

/// How much agents of one character differ.
struct Variety {
  bool differs = true;              ///< false: all look like the first of their character, whatever follows
  float tint = 1.0F;                ///< in colours, 0 to 1: as random_tints() and random_shade() draw them
  float size = usual_size_variety;  ///< in size, 0 to most_size_variety
  Clothes clothes = Clothes::own;   ///< pattern: they have the colours of ClothesPattern
  bool bodies = false;              ///< they have the bodies of CharacterRoles::bodies

  friend bool operator==(const Variety&, const Variety&) = default;
};
inline constexpr float most_size_variety = 0.3F;

/// Draws the clothes, hair and skin of one person: muted colours for most, an accent here and there.
Tints random_tints(Random& random);

inline constexpr float least_lightness = 0.85F, most_lightness = 1.04F;  ///< that a colour fades to

/// Returns a colour a little lighter or darker, so that no two people in one colour are quite alike.
std::uint32_t faded(std::uint32_t color, Random& random);

/// The shape of one body, each value from -1 to 1; all 0 is the character as it was made. A character whose file has no
/// `_SHAPE` and `_HAIR` shows none of it.
struct Variant {
  float build = 0.0F;     ///< slim to stout
  float frame = 0.0F;     ///< broad hips to broad shoulders
  float posture = 0.0F;   ///< upright to stooped
  float fullness = 0.0F;  ///< cropped hair to full hair
  float length = 0.0F;    ///< short hair to long hair

  std::uint32_t shape() const;  ///< AgentLook::shape
  std::uint32_t hair() const;   ///< AgentLook::hair

  friend bool operator==(const Variant&, const Variant&) = default;
};

/// Draws a woman or a man of any build; most are near the middle.
Variant random_variant(Random& random);

/// Draws AgentLook::shade for colours that are a file's own: up to 10% lighter or darker and 4% warmer or cooler, as
/// the screen counts, so that a colour keeps its name.
std::uint32_t random_shade(Random& random);

/// Returns colours between `first`, where `share` is 0, and `own`, where it is 1.
Tints between(const Tints& first, const Tints& own, float share);
/// Returns a shade that changes colours by a share, 0 to 1, of the change by `shade`.
std::uint32_t weaker_shade(std::uint32_t shade, float share);
/// Returns a size that was drawn, for agents that differ by `most` instead of the usual.
float varied_size(float size, float most);

/// Returns the look of a person in plain clothes.
render::AgentLook look_of(const Tints& tints, const Variant& variant, std::uint32_t shade);

/// Draws a person's height over the height in the file: 4% in standard deviation, 10% at most, as people differ.
float random_size(Random& random);

}  // namespace throng::app
