#include "engine/anim/run/store/copy_engine.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/base/guard.h"
#include "engine/anim/run/store/local_store.h"

namespace throng::anim::copy_engine_test {
namespace {

struct Memory {
  explicit Memory(std::size_t size) : bytes(allocate_aligned(size)) {
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i * 7);
  }
  AlignedBytes bytes;
};

TEST(CopyEngine, MovesWholeTransfersOnFinish) {
  const Memory main_memory(512);
  LocalStore store(1024);
  store.divide(512, 1, 0);
  CopyEngine engine;
  engine.fetch(main_memory.bytes.get(), store.fetch_buffer(0).data(), 512);
  engine.finish();
  EXPECT_EQ(std::memcmp(store.fetch_buffer(0).data(), main_memory.bytes.get(), 512), 0);
}

TEST(CopyEngine, SlicesMoveTheSameBytesInTheSameOrder) {
  const Memory first(192);
  const Memory second(320);
  LocalStore store(512);
  store.divide(512, 1, 0);
  CopyEngine engine;
  engine.fetch(first.bytes.get(), store.fetch_buffer(0).data(), 192);
  engine.fetch(second.bytes.get(), store.fetch_buffer(0).data() + 192, 320);
  engine.spread_over(3);
  for (int slice = 0; slice < 3; ++slice) engine.advance();
  EXPECT_EQ(std::memcmp(store.fetch_buffer(0).data(), first.bytes.get(), 192), 0);
  EXPECT_EQ(std::memcmp(store.fetch_buffer(0).data() + 192, second.bytes.get(), 320), 0);
}

TEST(CopyEngine, MovesAboutAsMuchInEachSlice) {
  constexpr std::size_t rows = 6, size = 64;
  Memory main_memory(rows * size);
  std::memset(main_memory.bytes.get(), 0, rows * size);
  LocalStore store(rows * size);
  store.divide(rows * size, 1, 0);
  std::memset(store.fetch_buffer(0).data(), 1, rows * size);
  CopyEngine engine;
  for (std::size_t row = 0; row < rows; ++row) {
    engine.write_back(store.fetch_buffer(0).data() + row * size, main_memory.bytes.get() + row * size, size);
  }
  engine.spread_over(3);
  for (const std::size_t moved : {0U, 2U, 4U, 6U}) {
    EXPECT_EQ(std::ranges::count(std::span(main_memory.bytes.get(), rows * size), std::byte{1}),
              static_cast<std::ptrdiff_t>(moved * size));
    engine.advance();
  }
}

TEST(CopyEngine, FetchesWithTheLastSliceAndWritesBackFromTheFirstOn) {
  Memory main_memory(128);
  LocalStore store(128);
  store.divide(128, 1, 0);
  std::byte* const local = store.fetch_buffer(0).data();
  std::memset(local, 0, 64);
  CopyEngine engine;
  engine.write_back(local, main_memory.bytes.get(), 64);
  engine.fetch(main_memory.bytes.get() + 64, local + 64, 64);
  engine.spread_over(2);
  engine.advance();
  EXPECT_EQ(std::ranges::count(std::span(main_memory.bytes.get(), 64), std::byte{0}), 64);
  release_guard(local + 64, 64);  // or nobody might look at what has not arrived
  EXPECT_NE(std::memcmp(local + 64, main_memory.bytes.get() + 64, 64), 0);
  engine.advance();
  EXPECT_EQ(std::memcmp(local + 64, main_memory.bytes.get() + 64, 64), 0);
}

TEST(CopyEngine, MovesRowsOfScatteredBlocksAndBack) {
  constexpr std::size_t size = 128, kept = 64, stride = 192;
  for (const int slices : {0, 1, 2, 5}) {
    const Memory before(3 * size);
    Memory main_memory(3 * size);
    const std::array<std::byte*, 3> blocks{main_memory.bytes.get() + 2 * size, main_memory.bytes.get(),
                                           main_memory.bytes.get() + size};
    LocalStore store(3 * stride);
    store.divide(3 * stride, 1, 0);
    const BlockRow row{.blocks = blocks, .local = store.fetch_buffer(0).data(), .stride = stride, .size = size};
    const auto move_all = [&](CopyEngine& engine) {
      engine.spread_over(slices);
      for (int i = 0; i < slices; ++i) engine.advance();
      return engine.finish();
    };
    CopyEngine engine;
    engine.fetch(row, 0);
    EXPECT_EQ(move_all(engine).bytes_in, 3 * size);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(std::memcmp(row.local + i * stride, blocks[i], size), 0);
      std::memset(row.local + i * stride, 0, size);
    }
    engine.write_back(row, kept);
    const CopyCounts back = move_all(engine);
    EXPECT_EQ(back.bytes_out, 3 * (size - kept));
    EXPECT_EQ(back.transfers, 3U);
    for (std::size_t i = 0; i < 3 * size; ++i) {
      EXPECT_EQ(main_memory.bytes[i], i % size < kept ? before.bytes[i] : std::byte{0}) << "byte " << i;
    }
  }
}

TEST(CopyEngine, FetchesNothingOfWhatIsSkipped) {
  constexpr std::size_t size = 192, skipped = 64;
  Memory main_memory(2 * size);
  const std::array<std::byte*, 2> blocks{main_memory.bytes.get() + size, main_memory.bytes.get()};
  LocalStore store(2 * size);
  store.divide(2 * size, 1, 0);
  CopyEngine engine;
  const BlockRow row{.blocks = blocks, .local = store.fetch_buffer(0).data(), .stride = size, .size = size};
  engine.fetch(row, skipped);
  EXPECT_EQ(engine.finish().bytes_in, 2 * (size - skipped));
  store.divide(2 * size, 1, 0);  // or nobody might look at what did not arrive
  for (std::size_t i = 0; i < 2 * size; ++i) {
    EXPECT_EQ(row.local[i], i % size < skipped ? std::byte{0} : blocks[i / size][i % size]) << "byte " << i;
  }
}

TEST(CopyEngine, CountsBytesAndTransfersOnceAndAlikeInAnyMode) {
  const Memory main_memory(256);
  Memory target(256);
  LocalStore store(256);
  store.divide(256, 1, 0);
  for (const int slices : {0, 1, 3}) {
    CopyEngine engine;
    engine.fetch(main_memory.bytes.get(), store.fetch_buffer(0).data(), 256);
    engine.finish();
    engine.write_back(store.fetch_buffer(0).data() + 64, target.bytes.get() + 64, 64);
    engine.spread_over(slices);
    for (int i = 0; i < slices; ++i) engine.advance();
    engine.finish();
    const CopyCounts counts = engine.take_counts();
    EXPECT_EQ(counts.bytes_in, 256U);
    EXPECT_EQ(counts.bytes_out, 64U);
    EXPECT_EQ(counts.transfers, 2U);
    EXPECT_EQ(engine.take_counts().bytes_in, 0U);
  }
}

TEST(CopyEngine, ReachesGuardedMemory) {
  const Memory main_memory(128);
  LocalStore store(128);
  store.divide(128, 1, 0);
  guard(main_memory.bytes.get(), 128);
  CopyEngine engine;
  engine.fetch(main_memory.bytes.get(), store.fetch_buffer(0).data(), 128);
  engine.finish();
  release_guard(main_memory.bytes.get(), 128);
  EXPECT_EQ(std::memcmp(store.fetch_buffer(0).data(), main_memory.bytes.get(), 128), 0);
}

#if defined(__SANITIZE_ADDRESS__)
TEST(CopyEngineDeathTest, NobodyElseReachesGuardedMemory) {
  const Memory main_memory(128);
  guard(main_memory.bytes.get(), 128);
  const volatile std::byte* kernel_that_skips_the_local_store = main_memory.bytes.get();
  EXPECT_DEATH({ [[maybe_unused]] const std::byte read = *kernel_that_skips_the_local_store; }, "use-after-poison");
  release_guard(main_memory.bytes.get(), 128);
}

TEST(CopyEngineDeathTest, ABlockThatHasNotArrivedCannotBeRead) {
  const Memory main_memory(256);
  LocalStore store(256);
  store.divide(256, 1, 0);
  CopyEngine engine;
  engine.fetch(main_memory.bytes.get(), store.fetch_buffer(0).data(), 128);
  engine.fetch(main_memory.bytes.get() + 128, store.fetch_buffer(0).data() + 128, 128);
  engine.spread_over(2);
  engine.advance();
  const volatile std::byte* local = store.fetch_buffer(0).data();
  EXPECT_DEATH({ [[maybe_unused]] const std::byte read = local[0]; }, "use-after-poison");
  engine.advance();
  const std::byte last_of_all = local[255];
  EXPECT_EQ(last_of_all, main_memory.bytes[255]) << "with the last slice both are there";
}
#endif

}  // namespace
}  // namespace throng::anim::copy_engine_test
