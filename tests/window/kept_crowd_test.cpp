// What a crowd file brings back in a window: two tunings to compare, the places of the camera, and a recorded crowd.
#include <fstream>

#include "tests/window/window_driver.h"

namespace throng::app {
namespace {

class KeptCrowd : public WindowDriver {
 protected:
  void keep_camera_at(const std::string& digit) {
    hold("Control_L");
    press(digit);
    let_go("Control_L");
    wait_for("a place at " + digit, [&](const Json& map) { return is_kept(map, digit); });
  }
  static bool is_kept(const Json& map, const std::string& digit) {
    return map["report"]["cameras"]["kept"][std::stoul(digit) - 1] == true;
  }
  void wait_for_all_of_it() {
    wait_for("both tunings", [](const Json& map) { return map["widgets"].contains("badge:pair"); });
    wait_for("the places", [](const Json& map) { return is_kept(map, "3") && !is_kept(map, "4"); });
    press("b");
    wait_for("the other tuning", [](const Json& map) { return map["shows_b"] == true; });
  }
};

TEST_F(KeptCrowd, BringsBackBothTuningsAndThePlacesOfTheCamera) {
  keep_camera_at("3");
  click("tab:Presets");
  press("b");
  wait_for("what to do", [](const Json& map) {
    return map["report"]["message"].get<std::string>().find("Copy A to B") != std::string::npos;
  });
  click("Copy A to B");
  wait_for("a badge", [](const Json& map) { return map["widgets"].contains("badge:pair"); });
  bring_into_sight("Crowd name.field");
  type_into("Crowd name.field", "mine");
  click("Save crowd");
  wait_for("the file", [](const Json& map) { return map["widgets"].contains("Open mine"); });
  keep_camera_at("4");
  click("Forget B");
  wait_for("A alone", [](const Json& map) { return !map["widgets"].contains("badge:pair"); });
  click("Open mine");
  click("unsaved:leave");
  wait_for_all_of_it();
  start_program({"mine.throng", "--size", "1280x720"});
  wait_for_all_of_it();
}

TEST_F(KeptCrowd, BringsBackARecordedCrowdAtItsMoment) {
  const std::string walk = (folder() / "a walk.csv").string();
  std::ofstream(walk) << "id,time,x,y\n1,0,0,0\n1,3600,9,0\n2,0,0,3\n2,3600,9,3\n";
  drop(walk);
  const auto is_there = [](const Json& map) {
    return map["tuning"]["scene"] == "tracks" && map["report"]["agents"] == 2 && map["report"]["drawn"] > 0;
  };
  const Json shown = wait_for("the recorded crowd", is_there);
  open_tab("Presets");
  type_in_tab("Crowd name.field", "walked");
  click_in_tab("Save crowd");
  wait_for_message("Wrote " + (folder() / "walked.throng").string());
  drop(std::string(THRONG_SOURCE_DIR) + "/tests/data/features/plain.glb");
  wait_for("another character", [](const Json& map) { return map["report"]["characters"].size() == 1; });
  drop((folder() / "walked.throng").string());
  wait_for_message("Opened");
  EXPECT_TRUE(is_there(next_map(2)));
  start_program({"walked.throng", "--size", "1280x720"});
  const Json again = wait_for("the recorded crowd", is_there);
  EXPECT_GE(again["report"]["tracks"]["seconds"], shown["report"]["tracks"]["seconds"]) << "and goes on from there";
}

}  // namespace
}  // namespace throng::app
