#include "app/files/progress_bar.h"

#include <gtest/gtest.h>

#include "tests/app/files/terminal.h"

namespace throng::app::progress_bar_test {
namespace {

TEST(ProgressBar, HasABarAndSaysWhatComesNow) {
  EXPECT_EQ(bar_text(0, "reading"), "[                    ] reading");
  EXPECT_EQ(bar_text(0.5, "Knight.glb, 38 of 76 clips"), "[==========          ] Knight.glb, 38 of 76 clips");
  EXPECT_EQ(bar_text(1.2, "done"), "[====================] done");
  EXPECT_EQ(bar_text(-1, "frame 7"), "frame 7");
}

TEST(ProgressBar, IsShownOnATerminalAndTakenAway) {
  const Terminal terminal;
  if (!terminal.is_there()) GTEST_SKIP() << "this system gives no terminal";
  {
    ProgressBar bar;
    bar.show(0.25, "placing 100,000 agents");
    EXPECT_NE(terminal.read_until("agents").find("[=====               ] placing 100,000 agents"), std::string::npos);
  }
  EXPECT_NE(terminal.read_until("\033[K").find("\r\033[K"), std::string::npos);
}

TEST(ProgressBar, ShowsNothingWhereThereIsNoTerminal) {
  testing::internal::CaptureStderr();
  { ProgressBar().show(0.5, "reading"); }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace throng::app::progress_bar_test
