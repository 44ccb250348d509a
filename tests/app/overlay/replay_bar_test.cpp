#include <string>

#include <gtest/gtest.h>

#include "tests/app/overlay/overlay_driver.h"

namespace throng::app::replay_bar_test {
namespace {

class ReplayBar : public testing::Test {
 protected:
  ReplayBar() {
    person_.report.replay = ReplayReport{.frame = 40, .frames = 101};
    person_.frames();
  }
  ReplayCommands click(const std::string& widget) { return person_.click(widget).replay; }
  ReplayCommands press(Key key) { return person_.press(key).replay; }

  OverlayDriver person_;
};

TEST_F(ReplayBar, IsThereOnlyInAReplay) {
  EXPECT_TRUE(person_.sees("Replay"));
  person_.report.replay.reset();
  person_.frames();
  EXPECT_FALSE(person_.sees("Replay"));
  EXPECT_FALSE(press(Key::space).change_pause);
}

TEST_F(ReplayBar, PausesAndStepsByButtonAndKey) {
  EXPECT_TRUE(click("Replay.play").change_pause);
  EXPECT_TRUE(press(Key::space).change_pause);
  EXPECT_EQ(click("Replay.back").step, -1);
  EXPECT_EQ(press(Key::left).step, -1);
  EXPECT_EQ(click("Replay.on").step, 1);
  EXPECT_EQ(press(Key::right).step, 1);
}

TEST_F(ReplayBar, GoesToTheFrameThatTheTrackIsPressedAt) {
  const auto wanted = click("Replay.track").go_to;
  ASSERT_TRUE(wanted);
  EXPECT_NEAR(static_cast<double>(*wanted), 51, 1) << "the middle of 101 frames";
}

TEST_F(ReplayBar, LoopsAndHasSpeeds) {
  EXPECT_TRUE(click("Replay.loop").change_loop);
  EXPECT_EQ(click("Replay.speed:0.25x").speed, 0.25F);
  EXPECT_EQ(click("Replay.speed:4x").speed, 4.0F);
}

TEST_F(ReplayBar, HasItsButtonsInASmallWindowToo) {
  for (int frame = 0; frame < 3; ++frame) {
    person_.overlay.begin_frame(600, 400, 1.0 / 60, {});
    person_.overlay.build(person_.report, person_.tuning);
  }
  EXPECT_TRUE(person_.sees("Replay.play"));
  EXPECT_TRUE(person_.sees("Replay.track"));
}

}  // namespace
}  // namespace throng::app::replay_bar_test
