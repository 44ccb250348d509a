#include "engine/anim/kernel/lanes/copy_blocks.h"

#include <array>

#include <gtest/gtest.h>

#include "engine/anim/kernel/kernels.h"
#include "tests/anim/kernel/validity.h"

namespace throng::anim::copy_blocks_test {
namespace {

struct alignas(64) Bytes {
  std::array<std::byte, 512> of{};
  std::byte* at(std::size_t index) { return of.data() + index; }
};

TEST(CopyBlocksJob, IsValidAsItsCommentsSay) {
  static Bytes main, local;
  static std::byte* const blocks[] = {main.at(256), main.at(0)};
  static std::byte* const one_missing[] = {main.at(0), nullptr};
  static std::byte* const off_the_alignment[] = {main.at(0), main.at(16)};
  const CopyBlocksJob job{.blocks = blocks, .local = local.at(0), .stride = 128, .offset = 64, .size = 128};
  expect_validity<CopyBlocksJob>(
      job, {{true, "nothing", [](CopyBlocksJob& job) { job = {}; }},
            {false, "a block missing", [](CopyBlocksJob& job) { job.blocks = one_missing; }},
            {false, "a block off the alignment", [](CopyBlocksJob& job) { job.blocks = off_the_alignment; }},
            {false, "no row of blocks", [](CopyBlocksJob& job) { job.local = nullptr; }},
            {false, "a row off the alignment", [](CopyBlocksJob& job) { job.local += 16; }},
            {false, "blocks that overlap", [](CopyBlocksJob& job) { job.stride = 64; }},
            {true, "one block without a stride",
             [](CopyBlocksJob& job) { job.blocks = job.blocks.first(1), job.stride = 0; }},
            {false, "an offset inside a line", [](CopyBlocksJob& job) { job.offset = 16; }},
            {false, "half a line", [](CopyBlocksJob& job) { job.size = 32; }},
            {false, "no line", [](CopyBlocksJob& job) { job.size = 0; }}});
}

TEST(CopyBlocks, BringsPartsOfBlocksInAndBackOnEveryTarget) {
  for (const Kernels& kernels : runnable_kernels()) {
    Bytes main, local;
    for (std::size_t i = 0; i < main.of.size(); ++i) main.of[i] = static_cast<std::byte>(i / 64 + 1);
    const Bytes before = main;
    std::byte* const blocks[] = {main.at(256), main.at(0)};
    CopyBlocksJob job{.blocks = blocks, .local = local.at(0), .stride = 192, .offset = 64, .size = 128};
    kernels.copy_blocks(job);
    const int expected[] = {6, 7, 0, 2, 3, 0, 0, 0};
    for (std::size_t i = 0; i < local.of.size(); ++i) EXPECT_EQ(static_cast<int>(local.of[i]), expected[i / 64]) << i;
    for (const std::size_t line : {1U, 2U, 5U, 6U}) *main.at(64 * line) = std::byte{99};
    job.inward = false;
    kernels.copy_blocks(job);
    EXPECT_EQ(main.of, before.of) << kernels.target;
  }
}

}  // namespace
}  // namespace throng::anim::copy_blocks_test
