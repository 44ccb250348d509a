#include "engine/anim/kernel/palette/palette_hash.h"

#include <array>
#include <bit>
#include <span>

namespace throng::anim {
namespace {

std::uint64_t hash_of_words(std::uint32_t joint, std::span<const std::uint32_t> words) {
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < words.size(); i += 2) {
    const std::uint32_t first = words[i] + palette_hash_factor(joint) * palette_hash_keys[i];
    const std::uint32_t second = words[i + 1] + palette_hash_factor(joint) * palette_hash_keys[i + 1];
    hash += std::uint64_t{first} * second;
  }
  return hash;
}

}  // namespace

std::uint64_t palette_entry_hash(std::uint32_t joint, const PaletteMatrix& matrix) {
  return hash_of_words(joint, std::bit_cast<std::array<std::uint32_t, 12>>(matrix));
}

std::uint64_t palette_entry_hash(std::uint32_t joint, const PackedPaletteEntry& entry) {
  return hash_of_words(joint, entry.words);
}

}  // namespace throng::anim
