#pragma once

#include <cstdint>

#include "engine/anim/base/transform.h"
#include "engine/anim/kernel/palette/packed_palette.h"

namespace throng::anim {

/// Returns the hash of the bits of one palette entry, 12 floats or 4 words, under its joint index. It is the sum of
/// (word + key) * (next word + next key) over words by twos (NH: Black et al., "UMAC", CRYPTO 1999), with keys of 32
/// bits and products of 64. Sums of entries tell palettes apart, in whatever order entries are written. Their low bits
/// know little of high bits of words, so a sum must be chained (base/hash.h) before a part of it is kept.
std::uint64_t palette_entry_hash(std::uint32_t joint, const PaletteMatrix& matrix);
std::uint64_t palette_entry_hash(std::uint32_t joint, const PackedPaletteEntry& entry);

/// The keys of the words, digits of the square roots of 2 to 37. Joint j multiplies them by palette_hash_factor(j).
alignas(16) inline constexpr std::uint32_t palette_hash_keys[] = {0x6A09E667, 0xBB67AE85, 0x3C6EF373, 0xA54FF53B,
                                                                  0x510E527F, 0x9B05688D, 0x1F83D9AB, 0x5BE0CD19,
                                                                  0xCBBB9D5D, 0x629A292A, 0x9159015A, 0x152FECD8};
constexpr std::uint32_t palette_hash_factor(std::uint32_t joint) { return 2U * joint + 1U; }

}  // namespace throng::anim
