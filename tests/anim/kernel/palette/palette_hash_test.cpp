#include "engine/anim/kernel/palette/palette_hash.h"

#include <cstring>
#include <set>

#include <gtest/gtest.h>

namespace throng::anim::palette_hash_test {
namespace {

PaletteMatrix counted() {
  PaletteMatrix matrix;
  float next = 1.0F;
  for (auto& row : matrix.rows) {
    for (float& value : row) value = next++;
  }
  return matrix;
}

TEST(PaletteEntryHash, ChangesWithEveryBitOfTheMatrix) {
  std::set<std::uint64_t> seen{palette_entry_hash(3, counted())};
  for (std::size_t bit = 0; bit < 8 * sizeof(PaletteMatrix); ++bit) {
    PaletteMatrix matrix = counted();
    unsigned char bytes[sizeof(PaletteMatrix)];
    std::memcpy(bytes, &matrix, sizeof(matrix));
    bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ (1U << (bit % 8)));
    std::memcpy(&matrix, bytes, sizeof(matrix));
    EXPECT_TRUE(seen.insert(palette_entry_hash(3, matrix)).second) << bit;
  }
}

TEST(PaletteEntryHash, SeesTwoSignsFlippedTogetherAndTwoValuesSwapped) {
  std::set<std::uint64_t> seen{palette_entry_hash(3, counted())};
  for (int a = 0; a < 12; ++a) {
    for (int b = a + 1; b < 12; ++b) {
      PaletteMatrix flipped = counted();
      flipped.rows[a / 4][a % 4] *= -1.0F;
      flipped.rows[b / 4][b % 4] *= -1.0F;
      EXPECT_TRUE(seen.insert(palette_entry_hash(3, flipped)).second) << a << " " << b;
      PaletteMatrix swapped = counted();
      std::swap(swapped.rows[a / 4][a % 4], swapped.rows[b / 4][b % 4]);
      EXPECT_TRUE(seen.insert(palette_entry_hash(3, swapped)).second) << a << " " << b;
    }
  }
}

TEST(PaletteEntryHash, SumNoticesTwoEntriesThatChangedPlaces) {
  PaletteMatrix other = counted();
  other.rows[1][2] = -7.5F;
  EXPECT_NE(palette_entry_hash(0, counted()) + palette_entry_hash(1, other),
            palette_entry_hash(1, counted()) + palette_entry_hash(0, other));
}

}  // namespace
}  // namespace throng::anim::palette_hash_test
