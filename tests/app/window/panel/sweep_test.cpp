// The sweep of the scheduling tab: what a person asks for, and what the curve offers.
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::sweep_test {
namespace {

SweepCurve swept_tiles() {
  SweepCurve curve{.value = SweptValue::tile, .stops = {}, .visits = 25, .all_visits = 25, .refusal = {}};
  for (const double tile : {1, 2, 4, 8, 16}) {
    curve.stops.push_back({.value = tile, .known = true, .cost = {.milliseconds = 1 + 1 / tile}});
  }
  return curve;
}

struct SweepTest : testing::Test {
  SweepTest() { driver.click("tab:Scheduling"); }

  void show(const SweepCurve& curve) {
    driver.report.sweep = curve;
    driver.frames();
  }
  /// A click into the curve, at a share of its width.
  void click_at(float share) {
    const UiRectangle place = *driver.find("Sweep curve");
    driver.point_at(place.x + share * place.width, place.y + place.height / 2);
    driver.input.push({.kind = InputEvent::Kind::button, .down = true});
    driver.input.push({.kind = InputEvent::Kind::button, .down = false});
    driver.frames();
  }

  OverlayDriver driver;
};

TEST_F(SweepTest, IsAskedForByItsButtonForTheValueThatWasPicked) {
  EXPECT_FALSE(driver.sees("Sweep curve"));
  driver.click("Vary:store");
  EXPECT_EQ(asked<StartSweep>(driver.click("Sweep")).value, SweptValue::local_store);
  EXPECT_EQ(driver.tuning, Tuning()) << "the overlay itself changes nothing";
}

TEST_F(SweepTest, CannotBeginWhileTimeStandsStill) {
  driver.tuning.paused = true;
  driver.frames();
  EXPECT_FALSE(asks<StartSweep>(driver.click("Sweep")));
}

TEST_F(SweepTest, ThatRunsCanOnlyBeStopped) {
  SweepCurve curve = swept_tiles();
  curve.runs = true;
  curve.visits = 10;
  show(curve);
  EXPECT_FALSE(driver.sees("Sweep"));
  EXPECT_TRUE(asks<StopSweep>(driver.click("Stop")));
  click_at(0.99F);
  EXPECT_EQ(driver.tuning.system.tile, 0) << "a stop is taken from a curve that is finished";
}

TEST_F(SweepTest, AStopOfTheCurveIsTakenByAClick) {
  show(swept_tiles());
  click_at(0.99F);
  EXPECT_EQ(driver.tuning.system.tile, 16);
  click_at(0.15F);
  EXPECT_EQ(driver.tuning.system.tile, 1);
}

TEST_F(SweepTest, AStopThatWasRefusedIsLeftOut) {
  driver.shown_height = 720;  // nothing but the curve comes into view
  show(swept_tiles());
  const int all = driver.overlay.vertex_count();
  SweepCurve curve = swept_tiles();
  curve.stops.back().refused = true;
  show(curve);
  EXPECT_LT(driver.overlay.vertex_count(), all);
  click_at(0.99F);
  EXPECT_EQ(driver.tuning.system.tile, 0);
}

TEST_F(SweepTest, IsInTheMapStopByStop) {
  const auto in_map = [&] {
    const auto map = nlohmann::json::parse(to_json(driver.overlay.ui_map(), driver.tuning, driver.report));
    return map["report"]["sweep"];
  };
  EXPECT_TRUE(in_map().is_null());
  SweepCurve curve = swept_tiles();
  curve.stops.back().known = false;
  show(curve);
  EXPECT_EQ(in_map()["value"], "tile");
  EXPECT_EQ(in_map()["runs"], false);
  EXPECT_EQ(in_map()["stops"][0]["update_ms"], 2.0);
  EXPECT_TRUE(in_map()["stops"][4]["update_ms"].is_null());
}

TEST_F(SweepTest, TheGrainIsARowOfItsOwn) {
  driver.drag("Grain", 1);
  EXPECT_EQ(driver.tuning.system.cost.least_task, 1'000'000) << "nanoseconds";
  driver.click("Grain.reset");
  EXPECT_EQ(driver.tuning.system.cost.least_task, Tuning().system.cost.least_task);
}

}  // namespace
}  // namespace throng::app::sweep_test
