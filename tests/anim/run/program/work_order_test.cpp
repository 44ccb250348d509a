#include "engine/anim/run/program/work_order.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/run/program/cost_model.h"

namespace throng::anim::work_order_test {
namespace {

const PoseProgram walking, turning;

AgentWork agent(std::uint32_t number, std::uint16_t cost, std::uint8_t level = 0,
                const PoseProgram& program = walking) {
  return {.program = &program, .agent = number, .cost = cost, .level = level};
}

std::vector<std::uint32_t> numbers(std::span<const AgentWork> work) {
  std::vector<std::uint32_t> numbers;
  for (const AgentWork& each : work) numbers.push_back(each.agent);
  return numbers;
}

/// The order of some work, which is found again where it was.
class OrderOf {
 public:
  explicit OrderOf(std::span<const AgentWork> work) {
    find_runs(work, runs_);
    order_.sort({work, runs_});
  }
  const WorkOrder* operator->() const { return &order_; }

 private:
  std::vector<WorkRun> runs_;
  WorkOrder order_;
};

TEST(WorkOrder, PutsDearAgentsFirstAndKeepsEqualOnesInOrder) {
  const std::vector<AgentWork> work = {agent(0, 10), agent(1, 10), agent(7, 100), agent(2, 10), agent(8, 100)};
  const OrderOf order(work);
  EXPECT_EQ(numbers(order->work()), (std::vector<std::uint32_t>{7, 8, 0, 1, 2}));
}

TEST(WorkOrder, PutsGroupsOfDearAgentsFirstAndNeverMixesLevels) {
  std::vector<AgentWork> work;
  for (std::uint32_t i = 0; i < 32; ++i) work.push_back(agent(i, 20));
  for (std::uint32_t i = 0; i < 20; ++i) work.push_back(agent(i, i % 2 == 0 ? 60 : 20, 1));
  const OrderOf order(work);
  EXPECT_EQ(order->work().front().level, 1);
  EXPECT_TRUE(std::ranges::is_sorted(order->work(), std::greater{}, [](const AgentWork& each) { return each.level; }));
}

TEST(WorkOrder, LeavesACrowdOfOneGroupWhereItLies) {
  const std::vector<AgentWork> work = {agent(0, 10), agent(1, 11), agent(2, 10)};
  const OrderOf order(work);
  EXPECT_EQ(order->work().data(), work.data());
}

TEST(WorkOrder, FindsRunsThatCannotBeMadeLonger) {
  const std::vector<AgentWork> work = {agent(0, 10), agent(1, 10), agent(2, 10, 0, turning), agent(3, 11, 0, turning),
                                       agent(4, 11, 0, turning)};
  const OrderOf order(work);
  ASSERT_EQ(order->runs().size(), 3U);
  std::uint32_t next = 0;
  for (const WorkRun& run : order->runs()) {
    EXPECT_EQ(run.first, next);
    next += run.count;
  }
  EXPECT_EQ(next, work.size());
  EXPECT_EQ(order->runs()[1].first, 2U);
  EXPECT_EQ(order->runs()[2].count, 2U);
}

TEST(WorkOrder, PredictsTheSumOfAllCosts) {
  const std::vector<AgentWork> work = {agent(0, 10), agent(1, 10), agent(2, 70)};
  const OrderOf order(work);
  EXPECT_EQ(order->predicted(), 90 * cost_step);
}

TEST(WorkOrder, OfNobodyIsEmpty) {
  const OrderOf order({});
  EXPECT_TRUE(order->runs().empty());
  EXPECT_EQ(order->predicted(), 0.0);
}

}  // namespace
}  // namespace throng::anim::work_order_test
