#include <cmath>
#include <string>

#include "tests/window/window_driver.h"

namespace throng::app::lod_look_test {
namespace {

using Json = nlohmann::json;

class LookAtLod : public WindowDriver {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(WindowDriver::SetUp());
    click("tab:LOD skipping");
    scroll_down_at(1100, 500, 6);  // to the ways to look
  }
};

TEST_F(LookAtLod, AFrozenCameraDecidesWhileAnotherOneFlies) {
  press("space");
  wait_for("the pause", [](const Json& map) { return map["tuning"]["paused"] == true; });
  click("Freeze LOD camera");
  const Json before = wait_for("the frozen camera",
                               [](const Json& map) { return map["tuning"]["inspection"]["freeze_camera"] == true; });
  point_at(450, 300);
  button(3, true);
  point_at(100, 300);
  point_at(850, 300);
  const Json after =
      wait_for("another direction", [&](const Json& map) { return map["camera"]["yaw"] != before["camera"]["yaw"]; });
  button(3, false);
  EXPECT_EQ(next_map()["report"]["visible"], before["report"]["visible"]);
}

TEST_F(LookAtLod, HoldingXShowsTheExactCrowd) {
  const Json tuning = next_map()["tuning"];
  hold("x");
  wait_for("all agents to be posed", [](const Json& map) { return map["report"]["agents_updated"] == 50; });
  EXPECT_EQ(next_map()["tuning"], tuning) << "the values stay as they are";
  let_go("x");
  wait_for("level of detail", [](const Json& map) { return map["report"]["agents_updated"] < 50; });
}

TEST_F(LookAtLod, AllAgentsHaveAForcedInterval) {
  type_into("Force interval.field", "16");
  wait_for("all agents in view at interval 16", [](const Json& map) {
    const Json& counts = map["report"]["agents_by_interval"];
    return counts.size() == 16 && counts[15] == map["report"]["visible"] && map["report"]["visible"] > 0;
  });
}

TEST_F(LookAtLod, FiguresStandAboveHeads) {
  click("Above heads");
  wait_for("figures", [](const Json& map) { return map["report"]["heads"] > 0 && map["widgets"].contains("Heads"); });
}

TEST_F(LookAtLod, TheSplitLineFollowsTheMouseAndNothingElseDoes) {
  press("space");
  click("Split:exact | LOD");
  const Json before = wait_for("the line", [](const Json& map) { return map["widgets"].contains("split line"); });
  const Json line = before["widgets"]["split line"];
  const double x = line["x"].get<double>() + line["w"].get<double>() / 2;
  point_at(x, 400);
  button(1, true);
  for (const double way : {-40.0, -128.0}) {
    point_at(x + way, 410);
    wait_for("the line at the pointer", [&](const Json& map) {
      const double now = map["tuning"]["inspection"]["split_at"];
      return std::abs(now - (x + way) / 1280) < 0.002;
    });
  }
  button(1, false);
  const Json after = next_map();
  EXPECT_EQ(after["camera"], before["camera"]);
  EXPECT_TRUE(after["report"]["selected"].is_null());
}

TEST_F(LookAtLod, TheCrowdIsTakenBackInTime) {
  click("tab:Crowd");
  const Json before = wait_for("snapshots", [](const Json& map) { return map["report"]["snapshots"] >= 2; });
  press("space");
  const int kept =
      wait_for("the pause", [](const Json& map) { return map["tuning"]["paused"] == true; })["report"]["snapshots"];
  click_in_tab("Rewind");
  wait_for("one snapshot fewer", [&](const Json& map) { return map["report"]["snapshots"] == kept - 1; });
  press("space");
  next_map(5);
}

}  // namespace
}  // namespace throng::app::lod_look_test
