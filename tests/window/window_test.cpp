#include <cmath>
#include <string>

#include "tests/window/window_driver.h"

namespace throng::app::window_test {
namespace {

using Json = nlohmann::json;
using Window = WindowDriver;

TEST_F(Window, EveryTabOpensByAClick) {
  for (const std::string tab : {"LOD skipping", "Per-bone LOD", "Scheduling", "Crowd"}) {
    click("tab:" + tab);
    wait_for("the tab " + tab, [&](const Json& map) { return map["tab"] == tab; });
  }
}

TEST_F(Window, SpacePausesAndGoesOn) {
  for (const bool paused : {true, false}) {
    press("space");
    wait_for("the pause", [&](const Json& map) { return map["tuning"]["paused"] == paused; });
  }
}

TEST_F(Window, APressShorterThanAFrameCounts) {
  xdotool({"key", "--delay", "0", "space"});
  wait_for("the pause", [](const Json& map) { return map["tuning"]["paused"] == true; });
}

TEST_F(Window, AgentsComeAndGoWhileItRuns) {
  for (const int agents : {120, 3}) {
    type_into("Agents.field", std::to_string(agents));
    wait_for("as many agents", [&](const Json& map) { return map["report"]["agents"] == agents; });
  }
}

TEST_F(Window, ATrackCanBeDragged) {
  click("tab:LOD skipping");
  drag("Largest interval", 0.99);
  wait_for("the largest interval", [](const Json& map) { return map["tuning"]["largest_interval"] == 16; });
}

TEST_F(Window, ProcessingUnitsChangeWhileItRuns) {
  click("tab:Scheduling");
  for (const int pus : {3, 1}) {
    type_into("PUs.field", std::to_string(pus));
    wait_for("as many PUs", [&](const Json& map) { return map["report"]["pus"] == pus; });
  }
}

TEST_F(Window, ScheduleDoubleBufferAndTileChangeWhileItRuns) {
  click("tab:Scheduling");
  click("Schedule:levels");
  click("Double buffer:off");
  type_into("Tile.field", "4");
  wait_for("a frame with all of it", [](const Json& map) {
    const Json& tuning = map["tuning"];
    return tuning["schedule"] == "levels" && tuning["double_buffer"] == "off" && map["report"]["tile"] == 4;
  });
  next_map();
}

TEST_F(Window, AValueThatCannotBeIsRefusedInWordsAndNothingChanges) {
  click("tab:Scheduling");
  click("Stream:keyframe");
  wait_for("the stream", [](const Json& map) { return map["tuning"]["stream"] == "keyframe"; });
  type_into("Local store.field", "16");  // a fused keyframe character needs more
  const Json map = wait_for("a refusal", [](const Json& now) {
    return now["report"]["message"].get<std::string>().find("--local-store") != std::string::npos;
  });
  EXPECT_EQ(map["tuning"]["local_store_kib"], 0) << map["report"]["message"];
  next_map();
}

TEST_F(Window, WFliesAndARightDragLooksAround) {
  const Json before = next_map()["camera"];
  point_at(450, 300);
  hold("w");
  wait_for("another place", [&](const Json& map) {
    const Json& now = map["camera"];
    return std::hypot(now["x"].get<double>() - before["x"].get<double>(),
                      now["z"].get<double>() - before["z"].get<double>()) > 0.5;
  });
  let_go("w");
  button(3, true);
  point_at(550, 300);
  wait_for("another direction", [&](const Json& map) { return map["camera"]["yaw"] != before["yaw"]; });
  button(3, false);
}

TEST_F(Window, CPrintsTheCameraAsAnOption) {
  press("c");
  const auto line = program().read_line(soon());
  ASSERT_TRUE(line.has_value());
  EXPECT_EQ(line->rfind("--camera ", 0), 0U) << *line;
}

TEST_F(Window, KeysAreLettersWhileTyping) {
  click("Agents.field");
  wait_for("a text field that takes keys", [](const Json& map) { return map["typing"].get<bool>(); });
  press("space");
  press("Tab");
  const Json map = next_map();
  EXPECT_FALSE(map["tuning"]["paused"].get<bool>());
  EXPECT_FALSE(map["hidden"].get<bool>());
}

TEST_F(Window, TabHidesTheOverlayAndF1ShowsHelp) {
  press("F1");
  wait_for("the help card", [](const Json& map) { return map["help"].get<bool>(); });
  press("Tab");
  wait_for("nothing over the crowd",
           [](const Json& map) { return map["hidden"].get<bool>() && map["widgets"].empty(); });
  press("Tab");
  wait_for("the overlay", [](const Json& map) { return !map["widgets"].empty(); });
}

TEST_F(Window, EscapeEndsItWithStatusZero) {
  xdotool({"key", "Escape"});
  EXPECT_EQ(program().exit_status(soon()), 0);
}

}  // namespace
}  // namespace throng::app::window_test
