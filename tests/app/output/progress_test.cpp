#include "app/output/progress.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/app/files/terminal.h"

namespace throng::app::progress_test {
namespace {

TEST(ProgressOfARun, SaysHowFarItIsAndHowLongItGoesOn) {
  EXPECT_EQ(progress_text(30, 600, 12.5), "frame 30 of 600, 2.4 a second, 3 min 58 s left");
  EXPECT_EQ(progress_text(300, 600, 10), "frame 300 of 600, 30 a second, 10 s left");
  EXPECT_EQ(progress_text(7, 0, 0.5), "frame 7, 14 a second");
}

TEST(ProgressOfARun, HasTimesForPeople) {
  EXPECT_EQ(time_text(4.23), "4.2 s");
  EXPECT_EQ(time_text(38.4), "38 s");
  EXPECT_EQ(time_text(238), "3 min 58 s");
  EXPECT_EQ(time_text(7500), "2 h 5 min");
}

TEST(ProgressOfARun, HasABarOnATerminalWhileTheRunTakesLong) {
  const Terminal terminal;
  if (!terminal.is_there()) GTEST_SKIP() << "this system gives no terminal";
  Progress progress(4, false, std::chrono::milliseconds(0));
  progress.show(1);
  EXPECT_NE(terminal.read_until("frame 1").find("[=====               ] frame 1"), std::string::npos);
  EXPECT_EQ(progress.frame(), 1);
}

TEST(ProgressOfARun, SaysNothingWithoutATerminal) {
  testing::internal::CaptureStderr();
  {
    Progress progress(10);
    for (int frame = 1; frame <= 10; ++frame) progress.show(frame);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ProgressOfARun, SaysItInLinesToAnotherProgram) {
  testing::internal::CaptureStderr();
  {
    Progress progress(1000, true);
    for (int frame = 1; frame <= 1000; ++frame) progress.show(frame);
  }
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(said.starts_with("frame 1 of 1000, ")) << said;
  EXPECT_NE(said.find("\nframe 1000 of 1000, "), std::string::npos) << said;
  EXPECT_LT(std::ranges::count(said, '\n'), 900) << "no more than ten a second, beside the first and the last";
}

}  // namespace
}  // namespace throng::app::progress_test
