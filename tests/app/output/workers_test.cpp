#include "app/output/workers.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace throng::app::workers_test {
namespace {

TEST(OutputWorkers, OfOneThreadKeepTheOrder) {
  std::vector<int> done;
  Workers workers(1, 2);
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(workers.add([&done, i]() -> Status { return done.push_back(i), Done{}; }));
  }
  ASSERT_TRUE(workers.finish());
  ASSERT_EQ(done.size(), 100U);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(OutputWorkers, LetNoMoreWaitThanTheyMay) {
  std::atomic<int> added{0}, done{0}, most{0};
  Workers workers(2, 3);
  for (int i = 0; i < 200; ++i) {
    ASSERT_TRUE(workers.add([&]() -> Status { return ++done, Done{}; }));
    const int left = ++added - done;
    if (left > most) most = left;
  }
  ASSERT_TRUE(workers.finish());
  EXPECT_EQ(done, 200);
  EXPECT_LE(most, 3 + 2);
}

TEST(OutputWorkers, TellTheFirstFailureAndDoNothingAfterIt) {
  std::atomic<int> done{0};
  Workers workers(1, 1000);
  for (int i = 0; i < 10; ++i) {
    const Status added = workers.add([&, i]() -> Status {
      ++done;
      return i < 4 ? Status(Done{}) : Error{"job " + std::to_string(i)};
    });
    if (!added) break;
  }
  const Status finished = workers.finish();
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().message, "job 4");
  EXPECT_EQ(done, 5);
  EXPECT_FALSE(workers.add([]() -> Status { return Done{}; }));
}

TEST(OutputWorkers, MakeAnErrorOfAnException) {
  Workers workers(1, 1);
  ASSERT_TRUE(workers.add([]() -> Status { throw std::runtime_error("no more"); }));
  const Status finished = workers.finish();
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().message, "no more");
}

TEST(OutputWorkers, EndWithJobsThatHaveNotBegun) {
  const Workers workers(2, 10);
  Workers busy(1, 100);
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(busy.add([]() -> Status { return Done{}; }));
}

}  // namespace
}  // namespace throng::app::workers_test
