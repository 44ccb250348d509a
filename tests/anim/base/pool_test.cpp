#include "engine/anim/base/pool.h"

#include <cstring>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace throng::anim::pool_test {
namespace {

TEST(Pool, HandsOutZeroedAlignedBlocks) {
  Pool pool(3, 128);
  const Handle handle = pool.create();
  const std::byte* block = pool.block(handle);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % 64, 0U);
  for (std::size_t i = 0; i < 128; ++i) EXPECT_EQ(block[i], std::byte{0});
  EXPECT_EQ(handle.pool(), 3U);
}

TEST(Pool, AHandleDiesWithItsBlock) {
  Pool pool(0, 64);
  const Handle first = pool.create();
  pool.destroy(first);
  EXPECT_FALSE(pool.alive(first));
  const Handle second = pool.create();
  EXPECT_EQ(second.index(), first.index());
  EXPECT_TRUE(pool.alive(second));
  EXPECT_FALSE(pool.alive(first)) << "a new block in the old place must not answer to the old name";
}

TEST(Pool, AHandleOfAnotherPoolIsNotAlive) {
  Pool one(1, 64);
  const Pool two(2, 64);
  EXPECT_FALSE(two.alive(one.create()));
  EXPECT_FALSE(two.alive(Handle{}));
}

TEST(Pool, CreationMovesNoBlock) {
  Pool pool(0, 64);
  const Handle first = pool.create();
  const std::byte* place = pool.block(first);
  std::set<const std::byte*> places = {place};
  for (std::uint32_t i = 0; i < 3 * Pool::blocks_per_slab; ++i) places.insert(pool.block(pool.create()));
  EXPECT_EQ(pool.block(first), place);
  EXPECT_EQ(places.size(), 3U * Pool::blocks_per_slab + 1);
}

TEST(Pool, ReservedBlocksNeedNoNewSlab) {
  Pool pool(0, 64);
  pool.reserve(1500);
  const std::size_t reserved = pool.bytes_reserved();
  for (int i = 0; i < 1500; ++i) pool.create();
  EXPECT_EQ(pool.bytes_reserved(), reserved);
}

TEST(Pool, KeepsHandlesAndContentsWhenBlocksChangeTheirSize) {
  Pool pool(0, 64);
  std::vector<Handle> handles;
  for (int i = 0; i < 1200; ++i) {
    handles.push_back(pool.create());
    std::memcpy(pool.block(handles.back()), &i, sizeof(i));
  }
  pool.destroy(handles[7]);
  pool.resize_blocks(192, [](const std::byte* from, std::byte* to) { std::memcpy(to + 128, from, 64); });
  EXPECT_EQ(pool.block_size(), 192U);
  EXPECT_FALSE(pool.alive(handles[7]));
  for (int i = 8; i < 1200; ++i) {
    int kept = 0;
    std::memcpy(&kept, pool.block(handles[static_cast<std::size_t>(i)]) + 128, sizeof(kept));
    ASSERT_EQ(kept, i);
  }
}

TEST(Pool, SaysWhatItHolds) {
  Pool pool(0, 128);
  const Handle first = pool.create();
  pool.create();
  pool.destroy(first);
  const PoolMemory memory = pool.memory();
  EXPECT_EQ(memory.blocks_alive, 1U);
  EXPECT_EQ(memory.blocks_capacity, Pool::blocks_per_slab);
  EXPECT_EQ(memory.bytes_alive, 128U);
  EXPECT_EQ(memory.bytes_reserved, Pool::blocks_per_slab * 128U);
  EXPECT_GE(memory.bytes_of_tables, Pool::blocks_per_slab * 9U) << "a place, an owner and a generation a block";
}

TEST(Pool, AWornIndexRestsWhileOthersAreLeft) {
  Pool pool(0, 64);
  const Handle first = pool.create();
  Handle handle = first;
  for (int life = 1; life < static_cast<int>(PoolTables::lives_of_an_index); ++life) {
    pool.destroy(handle);
    handle = pool.create();
    ASSERT_EQ(handle.index(), first.index());
  }
  pool.destroy(handle);
  handle = pool.create();
  EXPECT_NE(handle.index(), first.index());
  EXPECT_FALSE(pool.alive(first));
}

TEST(Pool, NoHandleComesBackBeforeAllOthersAreWorn) {
  constexpr std::uint32_t most_blocks = 1100;
  constexpr std::uint32_t alive = 100;
  Pool pool(0, 64, most_blocks);
  std::vector<Handle> living;
  for (std::uint32_t i = 0; i < alive; ++i) living.push_back(pool.create());
  std::set<std::uint32_t> seen;
  for (std::uint32_t life = 0; life < (most_blocks - alive) * PoolTables::lives_of_an_index; ++life) {
    const Handle handle = pool.create();
    ASSERT_TRUE(seen.insert(handle.bits).second) << "after " << life << " creations";
    pool.destroy(handle);
  }
  const Handle again = pool.create();
  EXPECT_TRUE(seen.contains(again.bits)) << "the pool has no more names than these";
  EXPECT_EQ(again.generation(), 0U);
  for (const Handle handle : living) EXPECT_TRUE(pool.alive(handle));
}

TEST(Pool, CreatesNothingMoreWhereAsManyLiveAsCan) {
  constexpr std::uint32_t most_blocks = 5;
  Pool pool(0, 64, most_blocks);
  std::vector<Handle> living;
  for (std::uint32_t i = 0; i < most_blocks; ++i) living.push_back(pool.create());
  EXPECT_EQ(pool.room(), 0U);
  EXPECT_FALSE(pool.create().valid());
  EXPECT_EQ(pool.alive_count(), most_blocks);
  pool.destroy(living.back());
  EXPECT_TRUE(pool.create().valid());
}

TEST(Handle, PacksPoolGenerationAndIndex) {
  const Handle handle = Handle::make(30, 127, Handle::max_blocks - 1);
  EXPECT_EQ(handle.pool(), 30U);
  EXPECT_EQ(handle.generation(), 127U);
  EXPECT_EQ(handle.index(), Handle::max_blocks - 1);
  EXPECT_TRUE(handle.valid());
  EXPECT_FALSE(Handle{}.valid());
}

}  // namespace
}  // namespace throng::anim::pool_test
