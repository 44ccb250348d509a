#include <string>

#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::replay_bar_test {
namespace {

class ReplayBar : public testing::Test {
 protected:
  ReplayBar() {
    person_.report.replay = ReplayReport{.frame = 40, .frames = 101};
    person_.frames();
  }
  Requests click(const std::string& widget) { return person_.click(widget); }
  Requests press(Key key) { return person_.press(key); }

  OverlayDriver person_;
};

TEST_F(ReplayBar, IsThereOnlyInAReplay) {
  EXPECT_TRUE(person_.sees("Replay"));
  person_.report.replay.reset();
  person_.frames();
  EXPECT_FALSE(person_.sees("Replay"));
  EXPECT_FALSE(asks<ToggleReplayPause>(press(Key::space)));
}

TEST_F(ReplayBar, PausesAndStepsByButtonAndKey) {
  EXPECT_TRUE(asks<ToggleReplayPause>(click("Replay.play")));
  EXPECT_TRUE(asks<ToggleReplayPause>(press(Key::space)));
  EXPECT_EQ(asked<StepReplay>(click("Replay.back")).frames, -1);
  EXPECT_EQ(asked<StepReplay>(press(Key::left)).frames, -1);
  EXPECT_EQ(asked<StepReplay>(click("Replay.on")).frames, 1);
  EXPECT_EQ(asked<StepReplay>(press(Key::right)).frames, 1);
}

TEST_F(ReplayBar, GoesToTheFrameThatTheTrackIsPressedAt) {
  const auto wanted = asked<SeekReplay>(click("Replay.track"));
  EXPECT_NEAR(static_cast<double>(wanted.frame), 51, 1) << "the middle of 101 frames";
}

TEST_F(ReplayBar, LoopsAndHasSpeeds) {
  EXPECT_TRUE(asks<ToggleReplayLoop>(click("Replay.loop")));
  EXPECT_EQ(asked<SetReplaySpeed>(click("Replay.speed:0.25x")).speed, 0.25F);
  EXPECT_EQ(asked<SetReplaySpeed>(click("Replay.speed:4x")).speed, 4.0F);
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
