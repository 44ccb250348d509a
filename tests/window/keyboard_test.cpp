// The panel of the real window by real keys, without a mouse.
#include <string>

#include "tests/window/window_driver.h"

namespace throng::app::window_keyboard_test {
namespace {

using Json = nlohmann::json;

class KeyboardInTheWindow : public WindowDriver {
 protected:
  Json wait_for_focus(const std::string& widget) {
    return wait_for("the focus at " + widget, [&](const Json& map) { return map["focus"] == widget; });
  }
};

TEST_F(KeyboardInTheWindow, TunesAValueAndComesBack) {
  press("F6");
  wait_for_focus("Scene:plaza");
  press("Down");
  wait_for_focus("Agents");
  press("Return");
  wait_for("a field that takes keys", [](const Json& map) { return map["typing"].get<bool>(); });
  type("60");
  press("Return");
  wait_for("sixty agents", [](const Json& map) { return map["report"]["agents"] == 60; });
  press("Down");
  press("Down");
  wait_for_focus("Seed");
  press("Right");
  wait_for("the next seed", [](const Json& map) { return map["tuning"]["seed"] == 2; });
  press("Delete");
  wait_for("the seed of before", [](const Json& map) { return map["tuning"]["seed"] == 1; });
  xdotool({"key", "ctrl+Next"});
  wait_for("the next tab", [](const Json& map) { return map["tab"] == "LOD skipping"; });
  press("Escape");
  wait_for_focus("");
  press("space");
  wait_for("a pause", [](const Json& map) { return map["tuning"]["paused"].get<bool>(); });
}

TEST_F(KeyboardInTheWindow, FindsAValueByTypingAndChangesIt) {
  press("slash");
  wait_for("a field that takes keys", [](const Json& map) { return map["typing"].get<bool>(); });
  type("mesh_error_px");
  wait_for("what is found", [](const Json& map) { return map["widgets"].contains("Mesh error"); });
  press("Down");
  wait_for_focus("Mesh error");
  const double before = next_map()["tuning"]["mesh_error_px"];
  xdotool({"key", "shift+Right"});
  const Json map = wait_for("another value", [&](const Json& now) { return now["tuning"]["mesh_error_px"] != before; });
  EXPECT_NEAR(map["tuning"]["mesh_error_px"].get<double>(), before + 0.1, 1e-4);
  press("Escape");
  wait_for("the tab", [](const Json& now) { return now["widgets"].contains("Scene:plaza"); });
  press("Escape");
  wait_for_focus("");
}

}  // namespace
}  // namespace throng::app::window_keyboard_test
