// The map of the overlay that window tests go by.

#include <array>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/window/panel/overlay.h"
#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::ui_map_test {
namespace {

TEST(UiMap, SaysWhereWidgetsAreAndWhatIsSet) {
  OverlayDriver driver;
  driver.click("Scene:grid");
  const auto map = nlohmann::json::parse(to_json(driver.overlay.ui_map(), driver.tuning, driver.report));
  EXPECT_EQ(map["tab"], "Crowd");
  EXPECT_EQ(map["tuning"]["scene"], "grid");
  EXPECT_EQ(map["tuning"]["agents"], 1000);
  EXPECT_EQ(map["report"]["pus"], 2);
  EXPECT_GT(map["widgets"]["Agents"]["w"], 50);
}

TEST(UiMap, SurvivesNamesThatAreNotText) {
  FrameReport report;
  report.notice = "\xFF\xFE";
  EXPECT_TRUE(nlohmann::json::accept(to_json({}, {}, report)));
}

}  // namespace
}  // namespace throng::app::ui_map_test
