// The first hour of a person who has not read a word: what the person wants, and the steps in the panel that lead
// there.
#include <filesystem>
#include <string>

#include "tests/window/window_driver.h"

namespace throng::app::new_user_test {
namespace {

using Json = nlohmann::json;

class NewUser : public WindowDriver {
 protected:
  std::vector<std::string> options() const override { return {"--agents", "60", "--size", "1280x720"}; }
  void select_one_of_the_crowd() {
    open_tab("Crowd");
    click("Scene:grid");
    type_into("Agents.field", "1");
    wait_for("one agent", [](const Json& map) { return map["report"]["drawn"] == 1; });
    click_at({0.0F, 1.2F, 0.0F});
    wait_for("a selection", [](const Json& map) { return map["report"]["selected"].is_object(); });
  }
};

// Drop both files. Crowd: Model, the one that is wanted. Everyone is this.
TEST_F(NewUser, GivesAllAgentsOneModel) {
  drop(folder_of_models({"a.glb", "b.glb"}));
  wait_for("both", [](const Json& map) { return map["report"]["cast"].size() == 2 && map["report"]["drawn"] > 0; });
  click("Model");
  click("Model:b.glb");
  click_in_tab("Everyone is this");
  wait_for("one model alone", [](const Json& map) {
    return map["report"]["cast"][0]["agents"] == 0 && map["report"]["cast"][1]["agents"] == 60;
  });
}

// LOD skipping: read what limits the frame rate. Rule: off, and read the poses a frame; budget again.
TEST_F(NewUser, FindsWhatLevelOfDetailSaves) {
  open_tab("LOD skipping");
  const int saved = wait_for("skipped updates", [](const Json& map) {
    return map["frame"] > 30 && map["report"]["agents_updated"] < 60;
  })["report"]["agents_updated"];
  click_in_tab("Rule:off");
  wait_for("all agents posed", [](const Json& map) { return map["report"]["agents_updated"] == 60; });
  EXPECT_LT(saved, 60);
  click("Rule:budget");
  wait_for("the budget", [](const Json& map) { return map["tuning"]["lod"] == "budget"; });
}

// Click at an agent. LOD skipping: Selected only, Force interval. The badge says so; a click at it ends it.
TEST_F(NewUser, ForcesOneAgent) {
  select_one_of_the_crowd();
  open_tab("LOD skipping");
  click_in_tab("Selected only");
  bring_into_sight("Force interval.field");
  type_into("Force interval.field", "16");
  wait_for("the interval", [](const Json& map) { return map["tuning"]["forced_interval"] == 16; });
  click("badge:interval");
  wait_for("the rule again", [](const Json& map) { return map["tuning"]["forced_interval"] == 0; });
}

// Click at the graph below the crowd, where it is highest: Scheduling opens with the PUs of that frame.
TEST_F(NewUser, SeesWhatAPuDidInASlowFrame) {
  wait_for("a graph that reaches its middle", [](const Json& map) { return map["frame"] > 130; });
  click("Frame graph");
  wait_for("that frame", [](const Json& map) { return map["report"]["looked_at"].is_number(); });
  bring_into_sight("Timeline");
  click("Back to the last frames");
  wait_for("the last frames", [](const Json& map) { return map["report"]["looked_at"].is_null(); });
}

// Crowd: Camera, home.
TEST_F(NewUser, FindsTheWayBackHome) {
  const Json home = next_map()["camera"];
  point_at(450, 300);
  hold("w");
  wait_for("another place", [&](const Json& map) { return map["camera"] != home; });
  let_go("w");
  open_tab("Crowd");
  click_in_tab("Home");
  wait_for("home", [&](const Json& map) { return map["camera"] == home; });
}

}  // namespace
}  // namespace throng::app::new_user_test
