#include <cstring>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/base/guard.h"
#include "engine/anim/base/pool.h"

namespace throng::anim::pool_compaction_test {
namespace {

constexpr std::size_t block_size = 128;
constexpr std::size_t slab_bytes = Pool::blocks_per_slab * block_size;

// A pool of blocks that know their number.
struct NumberedBlocks {
  Pool pool{1, block_size};
  std::vector<Handle> handles;

  explicit NumberedBlocks(std::uint32_t count, std::size_t reserved = 0) {
    pool.reserve(reserved);
    for (std::uint32_t number = 0; number < count; ++number) {
      handles.push_back(pool.create());
      for (std::size_t at = 0; at < block_size; at += sizeof(number)) {
        std::memcpy(pool.block(handles.back()) + at, &number, sizeof(number));
      }
    }
  }

  void keep_every(std::uint32_t stride) {
    for (std::uint32_t number = 0; number < handles.size(); ++number) {
      if (number % stride != 0) pool.destroy(handles[number]);
    }
  }

  void expect_living_blocks_unchanged() const {
    for (std::uint32_t number = 0; number < handles.size(); ++number) {
      if (!pool.alive(handles[number])) continue;
      const std::vector<std::uint32_t> expected(block_size / sizeof(number), number);
      ASSERT_EQ(std::memcmp(pool.block(handles[number]), expected.data(), block_size), 0) << "block " << number;
    }
  }

  // Within one slab: the blocks lie side by side, in this order, from the pool's first place on.
  void expect_side_by_side(const std::vector<std::uint32_t>& numbers) const {
    const std::byte* first = pool.block(handles[numbers[0]]);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      EXPECT_EQ(pool.block(handles[numbers[i]]), first + i * block_size) << "block " << numbers[i];
    }
  }
};

TEST(PoolCompaction, LeavesNoHoleAndGivesBackAllEmptySlabsButASpare) {
  NumberedBlocks blocks(5 * Pool::blocks_per_slab);
  blocks.keep_every(8);
  const Compaction done = blocks.pool.compact();
  EXPECT_TRUE(done.complete);
  EXPECT_EQ(done.blocks_moved, 5U * Pool::blocks_per_slab / 8 - 1) << "the first block is in its place";
  EXPECT_EQ(done.bytes_given_back, 3 * slab_bytes);
  EXPECT_EQ(blocks.pool.bytes_reserved(), 2 * slab_bytes);
  blocks.expect_living_blocks_unchanged();
}

TEST(PoolCompaction, KeepsBlocksInTheOrderOfTheirPlaces) {
  NumberedBlocks blocks(12);
  blocks.keep_every(3);
  blocks.pool.compact();
  blocks.expect_side_by_side({0, 3, 6, 9});
}

TEST(PoolCompaction, KeepsTheSlabsThatWereReserved) {
  NumberedBlocks blocks(4 * Pool::blocks_per_slab);
  blocks.keep_every(4 * Pool::blocks_per_slab);
  blocks.pool.reserve(3 * Pool::blocks_per_slab);
  EXPECT_EQ(blocks.pool.compact().bytes_given_back, slab_bytes);
  blocks.pool.reserve(0);
  EXPECT_EQ(blocks.pool.compact().bytes_given_back, slab_bytes);
  EXPECT_EQ(blocks.pool.bytes_reserved(), 2 * slab_bytes) << "one in use and one spare";
}

TEST(PoolCompaction, SlabsThatWereReservedTogetherGoBackOneByOne) {
  constexpr std::uint32_t all = 6 * Pool::blocks_per_slab;
  NumberedBlocks blocks(all, all);
  blocks.keep_every(2);
  blocks.pool.reserve(0);
  EXPECT_EQ(blocks.pool.compact().bytes_given_back, 2 * slab_bytes) << "three in use and one spare";
  blocks.expect_living_blocks_unchanged();
  for (std::uint32_t i = 0; i < all; ++i) blocks.pool.create();
  EXPECT_EQ(blocks.pool.bytes_reserved(), 9 * slab_bytes);
  blocks.expect_living_blocks_unchanged();
}

TEST(PoolCompaction, MovesNothingInAPoolWithoutHoles) {
  NumberedBlocks blocks(1500);
  const Compaction done = blocks.pool.compact();
  EXPECT_TRUE(done.complete);
  EXPECT_EQ(done.blocks_moved, 0U);
  EXPECT_EQ(done.bytes_given_back, 0U);
}

TEST(PoolCompaction, AnEmptyPoolKeepsOneSlab) {
  NumberedBlocks blocks(3 * Pool::blocks_per_slab);
  for (const Handle handle : blocks.handles) blocks.pool.destroy(handle);
  EXPECT_EQ(blocks.pool.compact().bytes_given_back, 2 * slab_bytes);
  EXPECT_TRUE(blocks.pool.alive(blocks.pool.create()));
}

TEST(PoolCompaction, HandlesStayUniqueWhenTheirSlabsComeBack) {
  NumberedBlocks blocks(3 * Pool::blocks_per_slab);
  blocks.keep_every(2);
  blocks.pool.compact();
  for (std::uint32_t i = 0; i < 3 * Pool::blocks_per_slab; ++i) blocks.pool.create();
  blocks.expect_living_blocks_unchanged();
  for (std::uint32_t number = 1; number < blocks.handles.size(); number += 2) {
    EXPECT_FALSE(blocks.pool.alive(blocks.handles[number]));
  }
}

TEST(PoolCompaction, InPartsMovesNoMoreThanAskedAndEndsWhereTheWholeEnds) {
  NumberedBlocks blocks(3 * Pool::blocks_per_slab);
  blocks.keep_every(3);
  std::size_t moved = 0;
  Compaction done;
  while (!done.complete) {
    done = blocks.pool.compact_some(100);
    ASSERT_LE(done.blocks_moved, 100U);
    ASSERT_TRUE(done.complete || done.blocks_moved > 0) << "each part gets on";
    blocks.expect_living_blocks_unchanged();
    moved += done.blocks_moved;
  }
  EXPECT_EQ(moved, std::size_t{Pool::blocks_per_slab} - 1);
  EXPECT_EQ(blocks.pool.bytes_reserved(), 2 * slab_bytes);
  EXPECT_EQ(blocks.pool.compact().blocks_moved, 0U);
}

TEST(PoolCompaction, PlacesBlocksInTheOrderInWhichTheyAreRead) {
  NumberedBlocks blocks(8);
  blocks.pool.destroy(blocks.handles[1]);
  const std::vector<Handle> order = {blocks.handles[6], blocks.handles[2], blocks.handles[7]};
  EXPECT_TRUE(blocks.pool.compact(order).complete);
  blocks.expect_side_by_side({6, 2, 7});
  blocks.expect_living_blocks_unchanged();
  EXPECT_EQ(blocks.pool.compact(order).blocks_moved, 0U) << "what is in order stays";
}

TEST(PoolCompaction, PassesOverRepetitionsDeadHandlesAndThoseOfOtherPools) {
  NumberedBlocks blocks(6);
  blocks.pool.destroy(blocks.handles[0]);
  Pool other(2, block_size);
  const std::vector<Handle>& all = blocks.handles;
  const std::vector<Handle> order = {all[5], other.create(), all[5], all[0], Handle{}, all[3], all[5], all[1]};
  blocks.pool.compact(order);
  blocks.expect_side_by_side({5, 3, 1});
  blocks.expect_living_blocks_unchanged();
}

TEST(PoolCompaction, ReachesAnOrderInParts) {
  NumberedBlocks blocks(Pool::blocks_per_slab);
  blocks.keep_every(2);
  std::vector<Handle> backwards(blocks.handles.rbegin(), blocks.handles.rend());
  Compaction done;
  while (!done.complete) {
    done = blocks.pool.compact_some(3, backwards);
    ASSERT_LE(done.blocks_moved, 3U);
    ASSERT_TRUE(done.complete || done.blocks_moved >= 2);
  }
  blocks.expect_living_blocks_unchanged();
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t number = Pool::blocks_per_slab; number > 0; number -= 2) numbers.push_back(number - 2);
  blocks.expect_side_by_side(numbers);
}

#if defined(__SANITIZE_ADDRESS__)
TEST(PoolCompaction, GuardsCoverEveryBlockBeforeAndAfter) {
  NumberedBlocks blocks(3 * Pool::blocks_per_slab);
  blocks.keep_every(5);
  for (int round = 0; round < 2; ++round) {
    blocks.pool.guard_blocks();
    for (const Handle handle : blocks.handles) {
      if (!blocks.pool.alive(handle)) continue;
      ASSERT_TRUE(__asan_address_is_poisoned(blocks.pool.block(handle)));
    }
    blocks.pool.release_blocks();
    blocks.expect_living_blocks_unchanged();
    blocks.pool.compact();
  }
}
#endif

}  // namespace
}  // namespace throng::anim::pool_compaction_test
