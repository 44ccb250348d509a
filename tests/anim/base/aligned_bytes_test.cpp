#include "engine/anim/base/aligned_bytes.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include <gtest/gtest.h>

namespace throng::anim::aligned_bytes_test {
namespace {

constexpr std::size_t page = 4096;

TEST(AlignedBytes, AreZeroAndBeginAtALineWhateverTheirSize) {
  constexpr std::size_t mebibyte = std::size_t{1} << 20U;
  for (const std::size_t size : {std::size_t{1}, page, mebibyte - 1, mebibyte, 3 * mebibyte + 1}) {
    const AlignedBytes bytes = allocate_aligned(size);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(bytes.get()) % block_alignment, 0U) << size << " bytes";
    const std::span<const std::byte> all(bytes.get(), size);
    EXPECT_TRUE(std::ranges::all_of(all, [](std::byte byte) { return byte == std::byte{0}; })) << size << " bytes";
  }
}

}  // namespace
}  // namespace throng::anim::aligned_bytes_test
