// The figures of the panel in the real window: the error from the first second, a slow frame after it has passed, the
// slider over snapshots, and values that do nothing.

#include <string>

#include "tests/window/window_driver.h"

namespace throng::app::figures_test {
namespace {

using Json = nlohmann::json;

using FiguresInTheWindow = WindowDriver;

TEST_F(FiguresInTheWindow, HaveTheErrorOfFiftyAgentsWithinSixtyFrames) {
  const int frame = next_map()["frame"];
  const Json map = wait_for("errors", [](const Json& now) { return now["report"]["error"]["samples"] >= 200; });
  EXPECT_LE(map["frame"], frame + 60);
  EXPECT_GT(map["report"]["error"]["history"], 0);
}

TEST_F(FiguresInTheWindow, LookAtAFrameThatIsClickedAtUntilOneGoesBack) {
  wait_for("a graph that reaches its middle", [](const Json& map) { return map["frame"] > 130; });
  click("Frame graph");
  const Json map = wait_for("a frame", [](const Json& now) { return !now["report"]["looked_at"].is_null(); });
  EXPECT_EQ(map["tab"], "Scheduling");
  EXPECT_EQ(next_map(5)["report"]["looked_at"], map["report"]["looked_at"]) << "it stays";
  click("Back to the last frames");
  wait_for("the last frames", [](const Json& now) { return now["report"]["looked_at"].is_null(); });
}

TEST_F(FiguresInTheWindow, TheSliderOverSnapshotsTakesTheCrowdBack) {
  wait_for("snapshots", [](const Json& map) { return map["report"]["snapshots"] >= 4; });
  press("space");
  const Json before = wait_for("the pause", [](const Json& map) { return map["tuning"]["paused"] == true; });
  bring_into_sight("Back by");
  drag("Back by", 0.7);
  wait_for("fewer snapshots",
           [&](const Json& map) { return map["report"]["snapshots"] < before["report"]["snapshots"].get<int>() - 1; });
}

TEST_F(FiguresInTheWindow, AValueWithoutEffectSaysWhy) {
  click("tab:LOD skipping");
  const Json map = wait_for("the tab", [](const Json& now) { return now["tab"] == "LOD skipping"; });
  EXPECT_EQ(map["idle"]["Full rate until"], "the rule budget goes by pixels and milliseconds, not by metres");
  click("Rule:distance");
  wait_for("distances", [](const Json& now) { return !now["idle"].contains("Full rate until"); });
}

}  // namespace
}  // namespace throng::app::figures_test
