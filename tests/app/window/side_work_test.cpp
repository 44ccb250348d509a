#include "app/window/side_work.h"

#include <chrono>
#include <future>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::app::side_work_test {
namespace {

void wait_for_end(const SideWork& work) {
  while (!work.has_ended()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(SideWork, GoesOnBesideTheWindow) {
  std::promise<void> answer;
  bool is_done = false;
  SideWork work([&](const LoadProgress&) {
    answer.get_future().wait();
    is_done = true;
  });
  EXPECT_FALSE(work.has_ended()) << "it waits for this thread";
  answer.set_value();
  wait_for_end(work);
  EXPECT_TRUE(is_done);
  EXPECT_TRUE(work.outcome());
}

TEST(SideWork, TellsHowFarItIs) {
  std::promise<void> told, answer;
  SideWork work([&](const LoadProgress& progress) {
    progress(0.25, "Knight.glb");
    told.set_value();
    answer.get_future().wait();
  });
  told.get_future().wait();
  EXPECT_EQ(work.progress().share, 0.25);
  EXPECT_EQ(work.progress().what, "Knight.glb");
  answer.set_value();
}

TEST(SideWork, EndsAtItsNextProgressOnceItIsGivenUp) {
  bool is_done = false;
  SideWork work([&](const LoadProgress& progress) {
    for (int step = 0; step < 10'000; ++step) {
      progress(0, "a step");
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    is_done = true;
  });
  work.give_up();
  wait_for_end(work);
  EXPECT_FALSE(is_done);
  EXPECT_TRUE(work.outcome()) << "it did not fail";
}

TEST(SideWork, SaysWhyItFailed) {
  SideWork work([](const LoadProgress&) { throw std::runtime_error("no more paper"); });
  wait_for_end(work);
  ASSERT_FALSE(work.outcome());
  EXPECT_THAT(work.outcome().error().message, testing::HasSubstr("no more paper"));
}

}  // namespace
}  // namespace throng::app::side_work_test
