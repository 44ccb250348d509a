#include "app/people/crowd/character_look.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace throng::app {
namespace {

// 0xRRGGBB, sRGB, as a painter writes them.
constexpr std::uint32_t skins[]{0xE6BFA3, 0xDDAF8C, 0xD09A74, 0xC68863, 0xA56B46, 0x8A5635, 0x6B4128, 0x4E2F1E};
constexpr std::uint32_t hairs[]{0x17120F, 0x241A14, 0x3A281C, 0x4F3522, 0x6B4A2B,
                                0x8C6239, 0xB08D57, 0x8E8A86, 0x7A3B1F};
constexpr std::uint32_t muted_shirts[]{0x2F4A63, 0x46617A, 0x7C93A6, 0xE6E0D4, 0xD8CDB8, 0x8C8B86, 0x4B4F54,
                                       0x5E6B4E, 0x8A7A5C, 0x6D3B3F, 0x39534A, 0xB9A48A, 0xA9B7BE, 0x23272E};
constexpr std::uint32_t bright_shirts[]{0xC8452F, 0xE0A32E, 0x1F8A8C, 0x3C6FB6, 0xD9697B, 0x6FA04B, 0xE07B39};
constexpr std::uint32_t trousers[]{0x24344D, 0x33455F, 0x4F6580, 0x2B2C30, 0x45464A,
                                   0x8C7B62, 0xA6977E, 0x5A4B3C, 0x3F4638};
constexpr std::uint32_t shoes[]{0x1C1B1D, 0x2E2A28, 0x5A3D28, 0x7B5A3C, 0xDCD8D0, 0x6C7075, 0xA13A2E};

constexpr float share_of_accents = 0.22F;

std::uint32_t one_of(std::span<const std::uint32_t> colours, Random& random) {
  return colours[random.below(static_cast<std::uint32_t>(colours.size()))];
}

// A painter's colour with red in the lowest byte.
constexpr std::uint32_t red_lowest(std::uint32_t colour) {
  return (colour & 0xFFU) << 16U | (colour & 0xFF00U) | colour >> 16U;
}

// The darker the skin, the darker the hair may be expected: light hair only goes with the first tones.
std::span<const std::uint32_t> hairs_for(std::size_t skin) {
  const std::span<const std::uint32_t> all(hairs);
  return skin < 3 ? all : all.first(skin < 5 ? 5 : 3);
}

}  // namespace

// Not much lighter, or pale colours would burn out in the sun.
std::uint32_t faded(std::uint32_t color, Random& random) {
  const float lightness = random.between(least_lightness, most_lightness);
  std::uint32_t result = 0xFF;
  for (const unsigned shift : {16U, 8U, 0U}) {
    const float channel = static_cast<float>((color >> shift) & 0xFFU) * lightness;
    result = (result << 8U) | static_cast<std::uint32_t>(std::min(channel, 255.0F));
  }
  return result;
}

Tints random_tints(Random& random) {
  const std::uint32_t skin = random.below(static_cast<std::uint32_t>(std::size(skins)));
  const std::uint32_t hair = one_of(hairs_for(skin), random);
  const bool accent = random.chance(share_of_accents);
  const std::uint32_t shirt = accent ? one_of(bright_shirts, random) : one_of(muted_shirts, random);
  Tints tints{skins[skin], hair, shirt, one_of(trousers, random), one_of(shoes, random)};
  for (std::uint32_t& tint : tints) tint = faded(red_lowest(tint), random);
  return tints;
}

namespace {

std::uint32_t snorm8(float value) {
  const auto byte = static_cast<std::int8_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 127.0F));
  return static_cast<std::uint8_t>(byte);
}

// Between -1 and 1, the middle more likely than the ends.
float around_zero(Random& random) { return random.unit() + random.unit() - 1.0F; }

}  // namespace

std::uint32_t Variant::shape() const { return snorm8(build) | snorm8(frame) << 8U | snorm8(posture) << 16U; }
std::uint32_t Variant::hair() const { return snorm8(fullness) | snorm8(length) << 8U; }

Variant random_variant(Random& random) {
  Variant variant;
  const float side = random.chance(0.5F) ? 1.0F : -1.0F;
  variant.frame = side * random.between(0.35F, 1.0F);
  variant.build = 0.10F + 0.85F * around_zero(random);
  variant.posture = 0.15F + 0.8F * around_zero(random);
  const bool long_hair = random.chance(side < 0.0F ? 0.72F : 0.06F);
  variant.length = long_hair ? random.between(0.45F, 1.0F) : 0.0F;
  const bool cropped = !long_hair && random.chance(0.4F);
  variant.fullness = cropped ? random.between(-1.0F, -0.4F) : random.between(-0.2F, long_hair ? 0.45F : 0.9F);
  return variant;
}

std::uint32_t random_shade(Random& random) {
  constexpr float lightest = 0.10F, warmest = 0.04F;
  const float lightness = 1.0F + random.between(-lightest, lightest), warmth = random.between(-warmest, warmest);
  // Linear light goes nearly as the square of the value that the screen gets.
  const auto word = [](float on_screen) { return snorm8((on_screen * on_screen - 1.0F) / render::shade_reach); };
  return word(lightness * (1.0F + warmth)) | word(lightness) << 8U | word(lightness * (1.0F - warmth)) << 16U;
}

render::AgentLook look_of(const Tints& tints, const Variant& variant, std::uint32_t shade) {
  render::AgentLook look = render::plain_look();
  std::ranges::transform(tints, look.tints.begin(), [](std::uint32_t tint) { return render::tint_of(tint); });
  look.shape = variant.shape();
  look.hair = variant.hair();
  look.shade = shade;
  return look;
}

// A sum of four even draws is close to the bell curve, on every machine alike.
float random_size(Random& random) {
  constexpr float deviation = 0.04F, most = 0.10F, deviation_of_sum = 0.57735F;
  const float sum = random.unit() + random.unit() + random.unit() + random.unit() - 2.0F;
  return 1.0F + std::clamp(sum * (deviation / deviation_of_sum), -most, most);
}

// A share of 1, or the usual variety, keeps what was drawn, to the bit.
Tints between(const Tints& first, const Tints& own, float share) {
  if (share == 1.0F) return own;
  Tints tints{};
  for (std::size_t region = 0; region < tints.size(); ++region) {
    for (const unsigned shift : {0U, 8U, 16U, 24U}) {
      const auto from = static_cast<float>((first.at(region) >> shift) & 0xFFU);
      const auto to = static_cast<float>((own.at(region) >> shift) & 0xFFU);
      tints.at(region) |= static_cast<std::uint32_t>(std::lround(from + (to - from) * share)) << shift;
    }
  }
  return tints;
}

std::uint32_t weaker_shade(std::uint32_t shade, float share) {
  if (share == 1.0F) return shade;
  std::uint32_t weaker = 0;
  for (const unsigned shift : {0U, 8U, 16U}) {
    const auto full = static_cast<std::int8_t>(static_cast<std::uint8_t>(shade >> shift));
    const auto part = static_cast<std::int8_t>(std::lround(static_cast<float>(full) * share));
    weaker |= static_cast<std::uint32_t>(static_cast<std::uint8_t>(part)) << shift;
  }
  return weaker;
}

float varied_size(float size, float most) {
  return most == usual_size_variety ? size : 1.0F + (size - 1.0F) * (most / usual_size_variety);
}

}  // namespace throng::app
