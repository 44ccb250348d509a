#include <bit>

#include "engine/anim/base/hash.h"
#include "engine/anim/kernel/kernels.h"

namespace throng::anim {
namespace {

/// Odd, so that multiplying loses nothing: the fractional digits of the golden ratio.
constexpr std::uint64_t golden = 0x9E3779B97F4A7C15U;

}  // namespace

std::uint64_t palette_entry_hash(std::uint32_t joint, const PaletteMatrix& matrix) {
  std::uint64_t hash = golden * (joint + 1U);
  for (const auto& row : matrix.rows) {
    for (int pair = 0; pair < 4; pair += 2) {
      const std::uint64_t low = std::bit_cast<std::uint32_t>(row[pair]);
      const std::uint64_t high = std::bit_cast<std::uint32_t>(row[pair + 1]);
      const std::uint64_t bits = low | (high << 32U);
      hash = (std::rotl(hash, 23) ^ bits ^ (bits >> 29U)) * golden;
    }
  }
  return mix_bits(hash);
}

}  // namespace throng::anim
