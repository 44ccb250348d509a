// A replay in a window stays until it is closed, and a person goes to any frame of it.
#include <string>
#include <vector>

#include "tests/window/window_driver.h"

namespace throng::app::replay_test {
namespace {

using Json = nlohmann::json;

constexpr int recorded_frames = 40;

class ReplayInTheWindow : public WindowDriver {
 protected:
  void SetUp() override {
    ChildProcess recording({THRONG_PROGRAM, "--headless=none", "--agents", "30", "--pus", "1", "--frames",
                            std::to_string(recorded_frames), "--record", file()},
                           {});
    ASSERT_EQ(recording.exit_status(soon()), 0);
    ASSERT_NO_FATAL_FAILURE(WindowDriver::SetUp());
  }
  std::vector<std::string> options() const override { return {"--replay", file(), "--size", "1280x720"}; }
  std::string file() const { return (folder() / "run.rec").string(); }
  Json wait_for_replay(const std::string& what, const std::function<bool(const Json&)>& holds) {
    return wait_for(what, [&](const Json& map) {
      return !map["report"]["replay"].is_null() && holds(map["report"]["replay"]);
    })["report"]["replay"];
  }
  Json wait_for_the_end() {
    return wait_for_replay("the end", [](const Json& replay) { return replay["ended"].get<bool>(); });
  }
};

TEST_F(ReplayInTheWindow, StaysAtItsLastFrameAndSaysThatAllWereEqual) {
  const Json end = wait_for_the_end();
  EXPECT_EQ(end["frame"], recorded_frames);
  EXPECT_EQ(end["frames"], recorded_frames);
  EXPECT_EQ(end["outcome"], file() + ": all 40 frames are equal, the last of 30 agents");
  next_map(5);
  xdotool({"key", "Escape"});
  EXPECT_EQ(program().exit_status(soon()), 0);
}

TEST_F(ReplayInTheWindow, GoesWhereAPersonWants) {
  wait_for_the_end();
  click("Replay.speed:0.25x");
  drag("Replay.track", 0.25);
  wait_for_replay("an early frame", [](const Json& replay) { return replay["sought"] == 0 && replay["frame"] < 30; });
  wait_for_the_end();
  press("Left");
  wait_for_replay("a step back", [](const Json& replay) {
    return replay["frame"] == recorded_frames - 1 && replay["paused"] == true;
  });
  press("Right");
  wait_for_the_end();
  click("Replay.loop");
  press("space");
  wait_for_replay("a new beginning", [](const Json& replay) { return replay["frame"] < 20; });
  click("Replay.play");
  const Json paused = wait_for_replay("a pause", [](const Json& replay) { return replay["paused"].get<bool>(); });
  next_map();
  EXPECT_EQ(next_map()["report"]["replay"]["frame"], paused["frame"]);
}

}  // namespace
}  // namespace throng::app::replay_test
