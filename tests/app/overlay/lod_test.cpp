// The rows that look at level of detail and try another than the rule has.
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/overlay/overlay_driver.h"

namespace throng::app::lod_test {
namespace {

struct LodSkippingTab : testing::Test {
  LodSkippingTab() { driver.click("tab:LOD skipping"); }

  void scroll_down() {
    driver.point_at(1100, 600);
    driver.frames();
    driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = -100});
    driver.frames();
  }

  OverlayDriver driver;
  const LodInspection& look = driver.tuning.inspection;
};

TEST_F(LodSkippingTab, FreezesTheCameraAndSaysSoUntilItIsFreeAgain) {
  const int before = driver.overlay.vertex_count();
  driver.click("Freeze LOD camera");
  EXPECT_TRUE(look.freeze_camera);
  EXPECT_GT(driver.overlay.vertex_count(), before) << "a line over the crowd says it";
  driver.click("Freeze LOD camera.reset");
  EXPECT_FALSE(look.freeze_camera);
}

TEST_F(LodSkippingTab, ShowsThresholdsAndFigures) {
  driver.click("Thresholds");
  driver.click("Above heads");
  EXPECT_TRUE(look.thresholds);
  EXPECT_TRUE(look.figures_above_heads);
}

TEST_F(LodSkippingTab, SplitsThePictureAtALineThatCanBeDragged) {
  EXPECT_FALSE(driver.sees("Split at"));
  driver.click("Split:difference");
  EXPECT_EQ(look.split, Split::difference);
  driver.drag("Split at", 1);
  EXPECT_EQ(look.split_at, 1.0F);
  driver.click("Split.reset");
  EXPECT_EQ(look.split, Split::off);
}

TEST_F(LodSkippingTab, ForcesAnIntervalAndALevel) {
  driver.drag("Force interval", 1);
  EXPECT_EQ(look.forced_interval, 16);
  driver.click("Force level:2");
  EXPECT_EQ(look.forced_bone_level, 2);
  driver.click("Force level:rule");
  EXPECT_EQ(look.forced_bone_level, -1);
  driver.click("Selected only");
  EXPECT_TRUE(look.force_selected_only);
}

TEST_F(LodSkippingTab, OffersNoLevelThatTheCharacterDoesNotHave) {
  driver.tuning.inspection.forced_bone_level = 3;
  driver.report.level_bone_counts = {62, 20};
  driver.frames();
  EXPECT_TRUE(driver.sees("Force level:1"));
  EXPECT_FALSE(driver.sees("Force level:2"));
  EXPECT_EQ(look.forced_bone_level, 3) << "nobody touched it";
}

TEST_F(LodSkippingTab, AnIntervalCannotBeForcedWhereNothingIsSkipped) {
  driver.tuning.lod.rule = anim::LodRule::off;
  driver.frames();
  driver.drag("Force interval", 1);
  EXPECT_EQ(look.forced_interval, 0);
}

TEST_F(LodSkippingTab, WritesFiguresAboveHeadsThatAreInFrontOfTheCamera) {
  driver.report.camera = {.y = 1.7F, .z = 5};
  driver.frames();
  const int without = driver.overlay.vertex_count();
  driver.report.heads = {{.y = 1.9F, .interval = 4, .bone_level = 1}};
  driver.frames();
  EXPECT_GT(driver.overlay.vertex_count(), without);
  EXPECT_TRUE(driver.sees("Heads"));
  driver.report.heads.front().z = 50;
  driver.frames();
  EXPECT_EQ(driver.overlay.vertex_count(), without) << "behind it";
}

TEST_F(LodSkippingTab, UnderABudgetShowsItsLimitsInsteadOfDistances) {
  driver.click("Rule:distance");
  EXPECT_FALSE(driver.sees("Error limit"));
  EXPECT_TRUE(driver.sees("Full rate until"));
  EXPECT_FALSE(driver.sees("Limited by"));
  driver.click("Rule:budget");
  EXPECT_EQ(driver.tuning.lod.rule, anim::LodRule::budget);
  EXPECT_FALSE(driver.sees("Full rate until"));
  driver.click("Error limit.field");
  driver.type("0.5 px");
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.error_px, 0.5F);
  driver.click("Time limit.field");
  driver.type("none");
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.budget_ms, 0);
  EXPECT_TRUE(driver.sees("Limited by"));
}

TEST_F(LodSkippingTab, ShowsIntervalsOverDistanceAndOfWhichClip) {
  driver.report.thresholds = {{8, 2}, {16, 3}};
  scroll_down();
  EXPECT_TRUE(driver.sees("Interval over distance"));
  const int without_clip = driver.overlay.vertex_count();
  driver.report.threshold_clip = "Walking_A";
  driver.frames();
  EXPECT_GT(driver.overlay.vertex_count(), without_clip);
  driver.tuning.lod.rule = anim::LodRule::off;
  driver.frames();
  EXPECT_FALSE(driver.sees("Interval over distance"));
}

TEST_F(LodSkippingTab, TakesPartsOfTheFrameAwayToSeeWhatTheyCost) {
  scroll_down();
  driver.click("No drawing");
  EXPECT_TRUE(driver.tuning.taken_away.drawing);
  driver.click("No drawing.reset");
  EXPECT_FALSE(driver.tuning.taken_away.drawing);
}

TEST_F(LodSkippingTab, TellsTheErrorOnTheScreenOnceItIsMeasured) {
  scroll_down();
  EXPECT_FALSE(driver.sees("Largest pop"));
  driver.report.error.samples = 20;
  driver.frames();
  scroll_down();
  EXPECT_TRUE(driver.sees("Largest pop"));
}

TEST(ExactCrowd, IsAskedForWhileXIsHeldButNotWhileTyping) {
  OverlayDriver driver;
  const auto hold_x = [&](bool down) {
    driver.input.push({.kind = InputEvent::Kind::key, .key = Key::x, .down = down});
    return driver.frames(2).exact_crowd;
  };
  EXPECT_TRUE(hold_x(true));
  EXPECT_TRUE(driver.frames(2).exact_crowd) << "still held";
  EXPECT_FALSE(hold_x(false));
  driver.click("Agents.field");
  EXPECT_FALSE(hold_x(true)) << "a letter";
}

TEST(ExactCrowd, SkipsAndSimplifiesNothing) {
  Tuning tuning;
  tuning.inspection = {.freeze_camera = true, .forced_interval = 8, .forced_bone_level = 3};
  const Tuning exact = without_level_of_detail(tuning);
  EXPECT_EQ(exact.lod.rule, anim::LodRule::off);
  EXPECT_FALSE(exact.lod.bone_lod);
  EXPECT_FALSE(exact.lod.smooth);
  EXPECT_EQ(exact.mesh_lod, 0);
  EXPECT_EQ(exact.inspection.forced_bone_level, -1);
  EXPECT_TRUE(exact.inspection.freeze_camera) << "one still looks at the same agents";
}

TEST(Overlay, LeavesDistancesOfBoneLevelsAloneWhereTheErrorDecides) {
  OverlayDriver driver;
  driver.report = full_report();
  driver.click("tab:Per-bone LOD");
  for (const anim::LodRule rule : {anim::LodRule::budget, anim::LodRule::distance}) {
    driver.tuning.lod.rule = rule;
    driver.frames();
    const auto before = driver.tuning.lod.level_distances;
    driver.drag("Level 1 from", 0.9F);
    driver.drag("Level band", 0.2F);
    EXPECT_EQ(driver.tuning.lod.level_distances == before, rule == anim::LodRule::budget);
  }
}

TEST(OverlayMap, HasWhatIsLookedAtAndForced) {
  Tuning tuning;
  tuning.inspection.forced_interval = 5;
  const auto map = nlohmann::json::parse(to_json({}, tuning, {}));
  EXPECT_EQ(map["tuning"]["forced_interval"], 5);
  EXPECT_EQ(map["tuning"]["inspection"]["freeze_camera"], false);
  EXPECT_EQ(map["tuning"]["inspection"]["split"], "off");
}

}  // namespace
}  // namespace throng::app::lod_test
