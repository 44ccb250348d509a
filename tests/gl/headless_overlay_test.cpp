#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/window/demo.h"

namespace throng::app::headless_overlay_test {
namespace {

TEST(HeadlessOverlay, WritesTheMapOfTheLastFrame) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "throng_headless_ui.json";
  DemoOptions options;
  options.context = ContextKind::egl;
  options.force_software = true;
  options.tuning.agents = 5;
  options.frames = 3;
  options.width = 1000;
  options.height = 600;
  options.ui = true;
  options.ui_map = file.string();
  ASSERT_EQ(run_demo(options), 0);
  std::ifstream stream(file);
  const nlohmann::json map = nlohmann::json::parse(stream, nullptr, false);
  std::filesystem::remove(file);
  ASSERT_TRUE(map.is_object());
  EXPECT_EQ(map["tuning"]["agents"], 5);
  ASSERT_TRUE(map["widgets"].contains("tab:Crowd"));
  EXPECT_GT(map["widgets"]["tab:Crowd"]["x"], 500) << "the panel is at the right of the picture";
}

}  // namespace
}  // namespace throng::app::headless_overlay_test
