#include <string>

#include "tests/window/window_driver.h"

namespace throng::app::selection_test {
namespace {

using Json = nlohmann::json;

/// The first agent of the grid, alone in its middle.
class LoneAgent : public WindowDriver {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(WindowDriver::SetUp());
    click("Scene:grid");
    type_into("Agents.field", "1");
    wait_for("one agent", [](const Json& map) {
      return map["tuning"]["scene"] == "grid" && map["report"]["agents"] == 1 && map["report"]["drawn"] == 1;
    });
  }

  void wait_until_selected(bool selected) {
    wait_for(selected ? "a selection" : "no selection",
             [&](const Json& map) { return map["report"]["selected"].is_null() != selected; });
  }
};

constexpr glm::vec3 chest{0.0F, 1.2F, 0.0F};

TEST_F(LoneAgent, IsSelectedByAClickAndItsCardShowsItsGraph) {
  click_at(chest);
  const Json map = wait_for("its card", [](const Json& now) { return now["widgets"].contains("Selected"); });
  const Json selected = map["report"]["selected"];
  EXPECT_EQ(selected["agent"], 0);
  EXPECT_FALSE(selected["entities"].empty());
  EXPECT_TRUE(map["widgets"].contains("Entity 0"));
}

TEST_F(LoneAgent, IsDeselectedByAClickBesideItAndByEscape) {
  click_at(chest);
  wait_until_selected(true);
  click_at(chest + glm::vec3(1.5F, 0.0F, 0.0F));
  wait_until_selected(false);
  click_at(chest);
  wait_until_selected(true);
  press("Escape");
  wait_until_selected(false);
}

TEST_F(LoneAgent, ItsClipIsHeldByDraggingAndLetGo) {
  click_at(chest);
  wait_until_selected(true);
  click("tab:Agent");
  drag("Hold clip at", 0.7);
  const Json map =
      wait_for("a held clip", [](const Json& now) { return !now["report"]["selected"]["held_at"].is_null(); });
  EXPECT_GT(map["report"]["selected"]["history_frames"], 0);
  click("Let go");
  wait_for("a clip that plays", [](const Json& now) { return now["report"]["selected"]["held_at"].is_null(); });
}

TEST_F(LoneAgent, IsPushedOverByTheButtonAndGetsUp) {
  click_at(chest);
  wait_until_selected(true);
  click("Push over");
  for (const std::string posture : {"falls", "lies", "gets up", "upright"}) {
    wait_for(posture, [&](const Json& map) { return map["report"]["selected"]["posture"] == posture; });
  }
}

}  // namespace
}  // namespace throng::app::selection_test
