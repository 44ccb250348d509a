#include "tests/benchmark/programs/many_pus.h"

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace throng::app::many_pus_test {
namespace {

/// Equal tasks of a microsecond, shared out evenly.
SimulatedFrame even_frame(int tasks, int pus, double bytes = 0) {
  SimulatedRound round;
  round.tasks.assign(static_cast<std::size_t>(tasks), {.ns = 1000, .bytes = bytes});
  for (int pu = 0; pu <= pus; ++pu) round.firsts.push_back(tasks * pu / pus);
  return {.serial_ns = 0, .rounds = {round}};
}

TEST(ManyPus, ShareWorkWithoutLossWhereNothingCosts) {
  const FrameTime time = simulate({.name = "ideal", .pus = 8}, even_frame(800, 8));
  EXPECT_NEAR(time.ns(), 100'000, 1);
  EXPECT_NEAR(time.queue_ns + time.memory_ns + time.serial_ns, 0, 1);
}

TEST(ManyPus, WaitForSerialWorkWhateverTheirNumber) {
  SimulatedFrame frame = even_frame(800, 8);
  frame.serial_ns = 50'000;
  EXPECT_NEAR(simulate({.name = "ideal", .pus = 8}, frame).ns(), 150'000, 1);
}

TEST(ManyPus, HelpEachOtherWhereSharesAreUneven) {
  SimulatedFrame frame = even_frame(800, 2);
  frame.rounds.front().firsts = {0, 700, 800};
  EXPECT_NEAR(simulate({.name = "ideal", .pus = 2}, frame).ns(), 400'000, 1000);
}

TEST(ManyPus, WaitForOneTaskThatIsLong) {
  SimulatedFrame frame = even_frame(3, 2);
  frame.rounds.front().tasks.back().ns = 10'000;
  frame.rounds.front().firsts = {0, 2, 3};
  const FrameTime time = simulate({.name = "ideal", .pus = 2}, frame);
  EXPECT_NEAR(time.ns(), 10'000, 1);
  EXPECT_NEAR(time.queue_ns, 10'000 - 6'000, 1);
}

TEST(ManyPus, TakeAsLongAsTheirMemoryWhereTasksAskForMore) {
  // Eight PUs ask for 8 GB/s, a byte a nanosecond each, and get two.
  const ManyPus machine{.name = "slow memory", .pus = 8, .memory_gigabytes_per_second = 2};
  const FrameTime time = simulate(machine, even_frame(800, 8, 1000));
  EXPECT_NEAR(time.ns(), 400'000, 1);
  EXPECT_NEAR(time.memory_ns, 300'000, 1);
}

TEST(ManyPus, HaveAMemoryOnEachSocket) {
  const ManyPus machine{.name = "two", .pus = 8, .sockets = 2, .memory_gigabytes_per_second = 2};
  EXPECT_NEAR(simulate(machine, even_frame(800, 8, 1000)).ns(), 200'000, 1);
}

TEST(ManyPus, ReachTheMemoryOfAnotherSocketThroughALink) {
  ManyPus machine{
      .name = "two", .pus = 2, .sockets = 2, .memory_gigabytes_per_second = 100, .link_gigabytes_per_second = 0.25};
  EXPECT_NEAR(simulate(machine, even_frame(2, 2, 1000)).ns(), 1000, 1);
  machine.on_first_socket = true;
  EXPECT_NEAR(simulate(machine, even_frame(2, 2, 1000)).ns(), 4000, 1);
}

TEST(ManyPus, TakeTwiceAsLongOverACrowdThatIsTwiceAsLarge) {
  SimulatedFrame frame = even_frame(800, 8, 1000);
  frame.serial_ns = 500;
  const ManyPus machine{.name = "slow memory", .pus = 8, .memory_gigabytes_per_second = 2};
  const SimulatedFrame twice = repeated(frame, 2);
  EXPECT_EQ(twice.rounds.front().firsts, even_frame(1600, 8).rounds.front().firsts);
  EXPECT_NEAR(simulate(machine, twice).ns(), 2 * simulate(machine, frame).ns(), 1);
}

TEST(ManyPus, PayForWakingAndForLinesOfOthers) {
  const ManyPus machine{.name = "costs", .pus = 2, .wake_ns = 500, .line_ns = 10};
  // PU 1 wakes after 500 and 10, does its task, and reads the line of PU 0 to see that nothing is left.
  EXPECT_NEAR(simulate(machine, even_frame(2, 2)).ns(), 510 + 1000 + 10, 1);
}

}  // namespace
}  // namespace throng::app::many_pus_test
