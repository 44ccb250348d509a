#include <array>
#include <bit>
#include <span>

#include "engine/anim/base/hash.h"
#include "engine/anim/kernel/kernels.h"

namespace throng::anim {
namespace {

/// Odd, so that multiplying loses nothing: the fractional digits of the golden ratio.
constexpr std::uint64_t golden = 0x9E3779B97F4A7C15U;

/// Words by twos.
std::uint64_t hash_of_words(std::uint32_t joint, std::span<const std::uint32_t> words) {
  std::uint64_t hash = golden * (joint + 1U);
  for (std::size_t pair = 0; pair < words.size(); pair += 2) {
    const std::uint64_t bits = words[pair] | (std::uint64_t{words[pair + 1]} << 32U);
    hash = (std::rotl(hash, 23) ^ bits ^ (bits >> 29U)) * golden;
  }
  return mix_bits(hash);
}

}  // namespace

std::uint64_t palette_entry_hash(std::uint32_t joint, const PaletteMatrix& matrix) {
  return hash_of_words(joint, std::bit_cast<std::array<std::uint32_t, 12>>(matrix));
}

std::uint64_t palette_entry_hash(std::uint32_t joint, const PackedPaletteEntry& entry) {
  return hash_of_words(joint, entry.words);
}

}  // namespace throng::anim
