// One character alone in a real window, reached from the crowd and by the command line.

#include <string>

#include "tests/window/window_driver.h"

namespace throng::app::viewer_window_test {
namespace {

using Json = nlohmann::json;

constexpr glm::vec3 chest{0.0F, 1.2F, 0.0F};

class LoneAgentViewed : public WindowDriver {
 protected:
  std::vector<std::string> options() const override {
    return {"--agents", "1", "--scene", "grid", "--size", "1280x720"};
  }
  void view() {
    next_map();
    click_at(chest);
    wait_for("its card", [](const Json& map) { return map["widgets"].contains("View"); });
    click("View");
    wait_for("the viewer", [](const Json& map) { return !map["report"]["viewer"].is_null(); });
  }
};

TEST_F(LoneAgentViewed, PlaysAClipThatIsChosenIsScrubbedAndLeft) {
  view();
  click("Clip:wave");
  const Json map = wait_for("the clip that was chosen", [](const Json& now) {
    return now["report"]["viewer"]["clip"] == "wave" && now["report"]["viewer"]["seconds"] > 0.1;
  });
  EXPECT_TRUE(map["report"]["viewer"]["plays"]);
  drag("At", 0.5);
  wait_for("a clip that is held", [](const Json& now) { return !now["report"]["viewer"]["plays"]; });
  press("Escape");
  const Json crowd = wait_for("the crowd", [](const Json& now) { return now["report"]["viewer"].is_null(); });
  EXPECT_EQ(crowd["report"]["selected"]["agent"], 0) << "who was selected still is";
}

TEST_F(LoneAgentViewed, ADragTurnsItAndTheCameraOfTheCrowdStays) {
  const Json before = next_map()["camera"];
  view();
  point_at(300, 300);
  button(1, true);
  point_at(500, 320);
  button(1, false);
  click("Back to the crowd");
  const Json map = wait_for("the crowd", [](const Json& now) { return now["report"]["viewer"].is_null(); });
  EXPECT_EQ(map["camera"], before);
  EXPECT_EQ(map["report"]["selected"]["agent"], 0) << "a drag is no click at the crowd";
}

class ViewedFromTheStart : public WindowDriver {
 protected:
  std::vector<std::string> options() const override { return {"--agents", "5", "--view=walk", "--size", "1280x720"}; }
};

TEST_F(ViewedFromTheStart, HasTheCrowdBehindIt) {
  const Json map = wait_for("the viewer", [](const Json& now) { return !now["report"]["viewer"].is_null(); });
  EXPECT_EQ(map["report"]["viewer"]["clip"], "walk");
  click("Back to the crowd");
  wait_for("the crowd", [](const Json& now) { return now["report"]["drawn"] == 5; });
}

}  // namespace
}  // namespace throng::app::viewer_window_test
