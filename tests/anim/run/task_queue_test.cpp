#include "engine/anim/run/task_queue.h"

#include <algorithm>
#include <array>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace throng::anim {
namespace {

TEST(TaskQueue, GivesEachPuTheSameShareOfItsOwnFirst) {
  TaskQueue queue(3);
  for (int frame = 0; frame < 2; ++frame) {
    queue.open(std::array{0, 3, 6, 9});
    for (int i = 0; i < 3; ++i) {
      for (int pu = 0; pu < 3; ++pu) EXPECT_EQ(queue.take(pu), pu * 3 + i);
    }
    EXPECT_EQ(queue.take(1), std::nullopt);
  }
}

TEST(TaskQueue, LetsAPuThatIsDoneHelpTheOthers) {
  TaskQueue queue(2);
  queue.open(std::array{0, 2, 4});
  for (const int task : {2, 3, 0, 1}) EXPECT_EQ(queue.take(1), task);
  EXPECT_EQ(queue.take(0), std::nullopt);
}

TEST(TaskQueue, LetsAPuWithoutAShareHelp) {
  TaskQueue queue(7);
  queue.open(std::array{0, 0});
  EXPECT_EQ(queue.take(6), std::nullopt);
  queue.open(std::array{0, 3});
  EXPECT_EQ(queue.take(6), 0);
  EXPECT_TRUE(queue.take(0).has_value());
  EXPECT_TRUE(queue.take(0).has_value());
  EXPECT_EQ(queue.take(0), std::nullopt);
}

TEST(TaskQueue, HandsEachTaskToOnePuOnlyWhenAllTakeAtOnce) {
  constexpr int pus = 4, tasks = 5000;
  TaskQueue queue(pus);
  queue.open(std::array{0, 1000, 1000, 4000, tasks});
  std::vector<std::vector<int>> taken(pus);
  std::vector<std::thread> threads;
  for (int pu = 0; pu < pus; ++pu) {
    threads.emplace_back([&queue, &mine = taken[static_cast<std::size_t>(pu)], pu] {
      while (const auto task = queue.take(pu)) mine.push_back(*task);
    });
  }
  std::vector<int> all;
  for (int pu = 0; pu < pus; ++pu) {
    threads[static_cast<std::size_t>(pu)].join();
    all.insert(all.end(), taken[static_cast<std::size_t>(pu)].begin(), taken[static_cast<std::size_t>(pu)].end());
  }
  std::ranges::sort(all);
  ASSERT_EQ(all.size(), static_cast<std::size_t>(tasks));
  for (int task = 0; task < tasks; ++task) EXPECT_EQ(all[static_cast<std::size_t>(task)], task);
}

}  // namespace
}  // namespace throng::anim
