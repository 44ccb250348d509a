#include "engine/anim/kernel/palette/write_lines.h"

#include <array>

#include <gtest/gtest.h>

#include "engine/anim/kernel/kernels.h"
#include "tests/anim/kernel/validity.h"

namespace throng::anim::write_lines_test {
namespace {

struct alignas(64) Lines {
  std::array<float, 48> floats{};
};

TEST(WriteLinesJob, IsValidAsItsCommentsSay) {
  Lines lines;
  const WriteLinesJob job{.lines = lines.floats};
  expect_validity<WriteLinesJob>(
      job, {{true, "nothing", [](WriteLinesJob& job) { job.lines = {}; }},
            {false, "lines off the alignment", [](WriteLinesJob& job) { job.lines = job.lines.subspan(4, 16); }},
            {false, "half a line", [](WriteLinesJob& job) { job.lines = job.lines.first(24); }},
            {false, "no policy", [](WriteLinesJob& job) { job.stores = static_cast<StorePolicy>(3); }}});
}

TEST(WriteLines, FillsItsLinesAndNoOthersOnEveryTarget) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (const StorePolicy stores : {StorePolicy::plain, StorePolicy::prefetched, StorePolicy::streaming}) {
      Lines lines;
      kernels.write_lines({.lines = std::span(lines.floats).subspan(16, 16), .value = 7.0F, .stores = stores});
      kernels.fence_stores();
      for (std::size_t i = 0; i < lines.floats.size(); ++i) {
        EXPECT_EQ(lines.floats[i], i / 16 == 1 ? 7.0F : 0.0F) << kernels.target << " " << i;
      }
    }
  }
}

}  // namespace
}  // namespace throng::anim::write_lines_test
