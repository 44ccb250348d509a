// Work that is in no file is asked about before a real window leaves it.
#include "tests/window/close_button.h"
#include "tests/window/window_driver.h"

namespace throng::app::unsaved_test {
namespace {

class UnsavedInTheWindow : public WindowDriver {
 protected:
  void change_the_seed() {
    type_into("Seed.field", "7");
    wait_for("another seed", [](const Json& map) { return map["tuning"]["seed"] == 7; });
  }
  Json wait_for_question() {
    return wait_for("a question", [](const Json& map) { return map["widgets"].contains("unsaved:save"); });
  }
  void wait_for_no_question() {
    wait_for("no question", [](const Json& map) { return !map["widgets"].contains("unsaved:save"); });
  }
  void save_as(const std::string& name) {
    wait_for("a field for a name",
             [](const Json& map) { return map["widgets"].contains("picker:field") && map["typing"].get<bool>(); });
    type(name);
    xdotool({"key", "Return"});  // the program may end then, and shows no other frame
  }
};

TEST_F(UnsavedInTheWindow, KeepsItOpenUntilItIsSaved) {
  change_the_seed();
  ASSERT_TRUE(press_close_button(display()));
  wait_for_question();
  press("Escape");
  wait_for_no_question();
  ASSERT_TRUE(press_close_button(display()));
  wait_for_question();
  click("unsaved:save");
  save_as("mine");
  EXPECT_EQ(program().exit_status(soon()), 0);
  EXPECT_TRUE(std::filesystem::exists(folder() / "mine.throng"));
}

TEST_F(UnsavedInTheWindow, IsLeftWhenThatIsAnswered) {
  change_the_seed();
  xdotool({"key", "ctrl+q"});
  wait_for_question();
  xdotool({"key", "l"});
  EXPECT_EQ(program().exit_status(soon()), 0);
}

TEST_F(UnsavedInTheWindow, IsAskedAboutBeforeAnotherCrowdIsOpened) {
  xdotool({"key", "ctrl+s"});
  save_as("first");
  wait_for_message("first.throng");
  change_the_seed();
  drop((folder() / "first.throng").string());
  wait_for_question();
  EXPECT_EQ(next_map()["tuning"]["seed"], 7);
  press("l");
  wait_for("the crowd of the file", [](const Json& map) { return map["tuning"]["seed"] == 1; });
  wait_for_no_question();
  EXPECT_TRUE(press_close_button(display()));
  EXPECT_EQ(program().exit_status(soon()), 0) << "the file has all of it";
}

TEST_F(UnsavedInTheWindow, IsSavedByCtrlSWhichDoesNotFlyTheCamera) {
  xdotool({"key", "ctrl+s"});
  save_as("mine");
  wait_for_message("mine.throng");
  change_the_seed();
  point_at(300, 300);
  button(1, true);
  button(1, false);
  const Json before = next_map()["camera"];
  hold("Control_L");
  press("s");
  let_go("Control_L");
  wait_for_message("mine.throng");
  EXPECT_EQ(next_map()["camera"], before);
  EXPECT_TRUE(press_close_button(display()));
  EXPECT_EQ(program().exit_status(soon()), 0);
}

TEST_F(UnsavedInTheWindow, IsOpenedThroughThePicker) {
  folder_of_models({"fox.glb"});
  xdotool({"key", "ctrl+o"});
  wait_for("the picker", [](const Json& map) { return map["widgets"].contains("picker:models"); });
  click("picker:models");
  click("picker:fox.glb");
  wait_for("the model", [](const Json& map) { return map["report"]["characters"][0] != "mannequin (built in)"; });
  xdotool({"key", "ctrl+z"});
  wait_for("the people of before",
           [](const Json& map) { return map["report"]["characters"][0] == "mannequin (built in)"; });
}

}  // namespace
}  // namespace throng::app::unsaved_test
