#include "engine/base/gathered.h"

#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace throng::gathered_test {
namespace {

/// Runs each job on a thread of its own.
class Threads final : public Executor {
 public:
  void run(int jobs, Job job) override {
    std::vector<std::thread> threads;
    for (int index = 0; index < jobs; ++index) threads.emplace_back(job.run, job.context, index);
    for (std::thread& thread : threads) thread.join();
  }
};

constexpr std::size_t count = 5000;  // ends within a tile

bool is_picked(std::size_t i) { return i % 7 == 0 || i / 300 == 4; }

std::vector<std::uint32_t> picked_by(Executor& executor, int jobs) {
  Gathered<std::uint32_t> gathered;
  gathered.set_aside(count);
  const auto list = gathered.gather(count, executor, jobs, [](std::size_t i, std::uint32_t& listed) {
    listed = static_cast<std::uint32_t>(i);
    return is_picked(i);
  });
  return {list.begin(), list.end()};
}

TEST(Gathered, ListsPickedElementsInOneOrderForAnyNumberOfJobs) {
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (is_picked(i)) expected.push_back(i);
  }
  for (const int jobs : {1, 2, 3, 8}) {
    Threads threads;
    EXPECT_EQ(picked_by(threads, jobs), expected) << jobs << " jobs";
  }
}

TEST(Gathered, IsEmptyWhereNoElementIsPicked) {
  Gathered<std::uint32_t> gathered;
  gathered.set_aside(count);
  InOrder here;
  const auto none = gathered.gather(count, here, 1, [](std::size_t, std::uint32_t&) { return false; });
  EXPECT_TRUE(none.empty());
  EXPECT_TRUE(gathered.gather(0, here, 1, [](std::size_t, std::uint32_t&) { return true; }).empty());
}

}  // namespace
}  // namespace throng::gathered_test
