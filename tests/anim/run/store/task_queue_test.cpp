#include "engine/anim/run/store/task_queue.h"

#include <algorithm>
#include <array>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace throng::anim::task_queue_test {
namespace {

TEST(TaskQueue, GivesEachPuTheSameShareOfItsOwnFirst) {
  TaskQueue queue(3);
  for (int frame = 0; frame < 2; ++frame) {
    queue.open(std::array{0, 3, 6, 9});
    std::array takers = {TaskQueue::Taker(queue, 0), TaskQueue::Taker(queue, 1), TaskQueue::Taker(queue, 2)};
    for (int i = 0; i < 3; ++i) {
      for (int pu = 0; pu < 3; ++pu) EXPECT_EQ(takers[static_cast<std::size_t>(pu)].take(), pu * 3 + i);
    }
    EXPECT_EQ(takers[1].take(), std::nullopt);
  }
}

TEST(TaskQueue, LetsAPuThatIsDoneHelpTheOthers) {
  TaskQueue queue(2);
  queue.open(std::array{0, 2, 4});
  TaskQueue::Taker helper(queue, 1);
  for (const int task : {2, 3, 0, 1}) EXPECT_EQ(helper.take(), task);
  EXPECT_EQ(TaskQueue::Taker(queue, 0).take(), std::nullopt);
}

TEST(TaskQueue, LetsAPuWithoutAShareHelp) {
  TaskQueue queue(7);
  TaskQueue::Taker owner(queue, 0), helper(queue, 6);
  queue.open(std::array{0, 0});
  EXPECT_EQ(helper.take(), std::nullopt);
  queue.open(std::array{0, 3});
  EXPECT_EQ(helper.take(), 0);
  EXPECT_EQ(owner.take(), 1);
  EXPECT_EQ(owner.take(), 2);
  EXPECT_EQ(owner.take(), std::nullopt);
}

TEST(TaskQueue, HandsOutManyAtOnceButNoMoreThanAShareOfWhatIsLeft) {
  TaskQueue queue(2);
  queue.open(std::array{0, 40, 40});
  TaskQueue::Taker owner(queue, 0), helper(queue, 1);
  EXPECT_EQ(owner.take(), 0);
  EXPECT_EQ(helper.take(), 10) << "a quarter of 40 belongs to the owner";
  EXPECT_EQ(owner.take(), 1);
  EXPECT_EQ(helper.take(), 11);
  queue.open(std::array{0, 1000, 1000});
  owner = TaskQueue::Taker(queue, 0);
  EXPECT_EQ(owner.take(), 0);
  EXPECT_EQ(TaskQueue::Taker(queue, 1).take(), TaskQueue::most_at_once);
}

TEST(TaskQueue, HandsEachTaskToOnePuOnlyWhenAllTakeAtOnce) {
  constexpr int pus = 4, tasks = 5000;
  TaskQueue queue(pus);
  queue.open(std::array{0, 1000, 1000, 4000, tasks});
  std::vector<std::vector<int>> taken(pus);
  std::vector<std::thread> threads;
  for (int pu = 0; pu < pus; ++pu) {
    threads.emplace_back([&queue, &mine = taken[static_cast<std::size_t>(pu)], pu] {
      TaskQueue::Taker taker(queue, pu);
      while (const auto task = taker.take()) mine.push_back(*task);
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
}  // namespace throng::anim::task_queue_test
