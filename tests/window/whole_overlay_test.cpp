// A person's afternoon with the overlay, in one run of the real window: what one step leaves behind, the next one
// finds.
#include <filesystem>
#include <string>
#include <utility>

#include "tests/window/window_driver.h"

namespace throng::app::whole_overlay_test {
namespace {

using Json = nlohmann::json;

class WholeOverlay : public WindowDriver {
 protected:
  void wait_for_bones(const Json& names) {
    wait_for("bones in that order", [&](const Json& map) { return map["report"]["bones"] == names; });
  }

  // The list lies at the end of its tab; two steps of the wheel bring a leg, whose order may change, into view.
  void show_the_legs() {
    click("tab:Per-bone LOD");
    scroll_down_at(1100, 300, 40);
    const Json list = next_map()["widgets"]["Bone list"];
    scroll_down_at(list["x"].get<double>() + 50, list["y"].get<double>() + list["h"].get<double>() / 2, 2);
  }
  void order_bones() {
    const Json before = next_map()["report"]["bones"];
    ASSERT_EQ(before[12], "shin.L");
    ASSERT_EQ(before[13], "thigh.R");
    drag_to("Bone 13", "Bone 12");
    Json swapped = before;
    std::swap(swapped[12], swapped[13]);
    wait_for_bones(swapped);
    click("Undo");
    wait_for_bones(before);
  }
  void move_the_end_of_a_level() {
    const Json before = next_map()["report"]["level_bone_counts"];
    ASSERT_EQ(before[2], 15);
    drag_to("Border 2", "Bone 13");
    wait_for("a bone fewer", [](const Json& map) { return map["report"]["level_bone_counts"][2] == 14; });
    click("Undo");
    wait_for("the levels of before", [&](const Json& map) { return map["report"]["level_bone_counts"] == before; });
  }
  void change_units_and_their_stores() {
    click("tab:Scheduling");
    type_into("PUs.field", "3");
    type_into("Local store.field", "256");
    wait_for("three PUs of 256 KiB",
             [](const Json& map) { return map["report"]["pus"] == 3 && map["report"]["local_store_kib"] == 256; });
  }
  void sweep_the_tile() {
    const Json before = next_map()["tuning"];
    click("Vary:tile");
    click("Sweep");
    wait_for("a sweep that runs", [](const Json& map) { return map["report"]["sweep"]["runs"] == true; });
    const Json map = wait_for("its end", [](const Json& now) { return now["report"]["sweep"]["runs"] == false; });
    const Json sweep = map["report"]["sweep"];
    EXPECT_EQ(sweep["value"], "tile");
    EXPECT_EQ(sweep["stops"].size(), 5U);
    for (const Json& stop : sweep["stops"]) EXPECT_TRUE(stop["refused"] == true || stop["update_ms"] > 0) << stop;
    EXPECT_EQ(next_map()["tuning"], before) << "all values are as they were";
    EXPECT_EQ(next_map()["report"]["tile"], 16) << "and so is what the crowd is posed with";
  }
  void stop_a_sweep() {
    click("Vary:PUs");
    click("Sweep");
    wait_for("a sweep that runs", [](const Json& map) { return map["report"]["sweep"]["runs"] == true; });
    click("Stop");
    wait_for("no sweep", [](const Json& map) { return map["report"]["sweep"]["runs"] == false; });
    EXPECT_EQ(next_map()["report"]["pus"], 3) << "as it was typed";
  }
  void look_at_both_crowds() {
    click("tab:LOD skipping");
    scroll_down_at(1100, 500, 6);
    for (const std::string split : {"exact | LOD", "difference", "off"}) {
      click("Split:" + split);
      wait_for("the split " + split, [&](const Json& map) { return map["tuning"]["inspection"]["split"] == split; });
      next_map(3);
    }
  }
  void freeze_and_fly_on() {
    click("Freeze LOD camera");
    const Json before = next_map()["camera"];
    point_at(450, 300);
    hold("s");
    wait_for("another place", [&](const Json& map) { return map["camera"] != before; });
    let_go("s");
    EXPECT_TRUE(next_map()["tuning"]["inspection"]["freeze_camera"].get<bool>());
    click("Freeze LOD camera");
  }
  void select_an_agent_and_scrub() {
    click("tab:Crowd");
    click_in_tab("Scene:grid");
    type_in_tab("Agents.field", "1");
    wait_for("one agent", [](const Json& map) { return map["report"]["agents"] == 1 && map["report"]["drawn"] == 1; });
    click_at({0.0F, 1.2F, 0.0F});
    click("tab:Agent");
    wait_for("a selection", [](const Json& map) { return !map["report"]["selected"].is_null(); });
    drag("Hold clip at", 0.7);
    wait_for("a held clip", [](const Json& map) { return !map["report"]["selected"]["held_at"].is_null(); });
    click("Let go");
    wait_for("a clip that plays", [](const Json& map) { return map["report"]["selected"]["held_at"].is_null(); });
  }
  // While it pauses, no more moments are kept.
  void go_back_in_time() {
    click("tab:Crowd");
    wait_for("two moments", [](const Json& map) { return map["report"]["snapshots"] >= 2; });
    click_in_tab("Pause");
    const int kept =
        wait_for("a pause", [](const Json& map) { return map["tuning"]["paused"].get<bool>(); })["report"]["snapshots"];
    click_in_tab("Rewind");
    wait_for("an earlier moment", [&](const Json& map) { return map["report"]["snapshots"] == kept - 1; });
    click_in_tab("Pause");
  }
  void begin_a_recording() {
    press("r");
    wait_for_message("is recorded");
  }
  void end_the_recording() {
    press("r");
    wait_for_message("Wrote " + (folder() / "throng-1.rec").string());
  }
  void drop_files() {
    const std::string bad = std::string(THRONG_SOURCE_DIR) + "/README.md";
    const std::string good = std::string(THRONG_SOURCE_DIR) + "/tests/data/features/plain.glb";
    const Json before = next_map()["report"]["characters"];
    drop(bad);
    EXPECT_EQ(wait_for_message(bad)["report"]["characters"], before);
    drop(good);
    wait_for("the new character", [&](const Json& map) {
      return map["report"]["characters"] == Json::array({good}) && map["report"]["drawn"] > 0;
    });
  }
};

TEST_F(WholeOverlay, IsDrivenThroughByAScript) {
  ASSERT_NO_FATAL_FAILURE(begin_a_recording());
  ASSERT_NO_FATAL_FAILURE(go_back_in_time());
  ASSERT_NO_FATAL_FAILURE(show_the_legs());
  ASSERT_NO_FATAL_FAILURE(order_bones());
  ASSERT_NO_FATAL_FAILURE(move_the_end_of_a_level());
  ASSERT_NO_FATAL_FAILURE(change_units_and_their_stores());
  ASSERT_NO_FATAL_FAILURE(sweep_the_tile());
  ASSERT_NO_FATAL_FAILURE(stop_a_sweep());
  ASSERT_NO_FATAL_FAILURE(look_at_both_crowds());
  ASSERT_NO_FATAL_FAILURE(freeze_and_fly_on());
  ASSERT_NO_FATAL_FAILURE(select_an_agent_and_scrub());
  ASSERT_NO_FATAL_FAILURE(drop_files());
  ASSERT_NO_FATAL_FAILURE(end_the_recording());
  press("Escape");
  wait_for("a question about the values", [](const Json& map) { return map["widgets"].contains("unsaved:leave"); });
  xdotool({"key", "l"});
  EXPECT_EQ(program().exit_status(soon()), 0);
  ChildProcess replay({THRONG_PROGRAM, "--headless=none", "--replay", (folder() / "throng-1.rec").string()}, {});
  EXPECT_EQ(replay.exit_status(soon()), 0) << "all of the afternoon is repeated to the bit";
}

}  // namespace
}  // namespace throng::app::whole_overlay_test
