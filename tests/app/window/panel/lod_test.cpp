// The rows that look at level of detail and try another than the rule has.
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::lod_test {
namespace {

struct LodSkippingTab : testing::Test {
  LodSkippingTab() { driver.click("tab:LOD skipping"); }

  void scroll_down(float steps = 100) {
    driver.point_at(1100, 600);
    driver.frames();
    driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = -steps});
    driver.frames();
  }
  void scroll_to_ways_to_look() { scroll_down(6); }

  OverlayDriver driver;
  const LodInspection& look = driver.tuning.inspection;
};

TEST_F(LodSkippingTab, FreezesTheCameraAndSaysSoUntilItIsFreeAgain) {
  scroll_to_ways_to_look();
  const int before = driver.overlay.vertex_count();
  driver.click("Freeze LOD camera");
  EXPECT_TRUE(look.freeze_camera);
  EXPECT_GT(driver.overlay.vertex_count(), before) << "a line over the crowd says it";
  driver.click("Freeze LOD camera.reset");
  EXPECT_FALSE(look.freeze_camera);
}

TEST_F(LodSkippingTab, ShowsThresholdsAndFigures) {
  scroll_to_ways_to_look();
  driver.click("Thresholds");
  driver.click("Above heads");
  EXPECT_TRUE(look.thresholds);
  EXPECT_TRUE(look.figures_above_heads);
}

TEST_F(LodSkippingTab, SplitsThePictureAtALineThatCanBeDragged) {
  scroll_to_ways_to_look();
  driver.drag("Split at", 1);
  EXPECT_EQ(look.split_at, LodInspection().split_at) << "nothing is split";
  driver.click("Split:difference");
  EXPECT_EQ(look.split, Split::difference);
  driver.drag("Split at", 1);
  EXPECT_EQ(look.split_at, 1.0F);
  driver.click("Split.reset");
  EXPECT_EQ(look.split, Split::off);
}

TEST_F(LodSkippingTab, ForcesAnIntervalAndALevel) {
  scroll_to_ways_to_look();
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
  scroll_to_ways_to_look();
  driver.tuning.inspection.forced_bone_level = 3;
  driver.report.level_bone_counts = {62, 20};
  driver.frames();
  EXPECT_TRUE(driver.sees("Force level:1"));
  EXPECT_FALSE(driver.sees("Force level:2"));
  EXPECT_EQ(look.forced_bone_level, 3) << "the person did not touch it";
}

TEST_F(LodSkippingTab, AnIntervalCannotBeForcedWhereNothingIsSkipped) {
  scroll_to_ways_to_look();
  driver.tuning.lod.rule = LodRule::off;
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

TEST_F(LodSkippingTab, DisablesWhatTheRuleDoesNotReadAndSaysWhy) {
  driver.report.situation.mesh_levels = 1;
  const auto is_idle = [&](const char* row) { return driver.why_idle(row) != nullptr; };
  for (const char* const rule : {"off", "distance", "budget"}) {
    driver.click(std::string("Rule:") + rule);
    const bool distance = rule == std::string("distance"), budget = rule == std::string("budget");
    EXPECT_EQ(is_idle("Full rate until"), !distance) << rule;
    EXPECT_EQ(is_idle("Interval step"), !distance) << rule;
    EXPECT_EQ(is_idle("Error limit"), !budget) << rule;
    EXPECT_EQ(is_idle("Time limit"), !budget) << rule;
    EXPECT_EQ(is_idle("Smooth"), !distance && !budget) << rule;
    EXPECT_EQ(driver.sees("Limited by"), budget) << rule;
    const Tuning before = driver.tuning;
    driver.drag("Full rate until", 0.9F);
    EXPECT_EQ(driver.tuning == before, !distance) << rule;
  }
  EXPECT_EQ(*driver.why_idle("Full rate until"), "the rule budget goes by pixels and milliseconds, not by metres");
}

TEST_F(LodSkippingTab, TellsTheReasonWhereThePointerRestsOnADisabledRow) {
  const auto vertices_at = [&](const char* row) {
    const UiRectangle place = *driver.find(row);
    driver.point_at(place.x + 4, place.y + place.height / 2);
    driver.frames(60);
    return driver.overlay.vertex_count();
  };
  const int elsewhere = vertices_at("tab:Crowd"), there = vertices_at("Full rate until.label");
  EXPECT_GT(there, elsewhere + 200) << "a tooltip with some words";
}

TEST_F(LodSkippingTab, TakesLimitsUnderABudget) {
  driver.click("Error limit.field");
  driver.type("0.5 px");
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.error_px, 0.5F);
  driver.click("Time limit.field");
  driver.type("none");
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.budget_ms, 0);
}

TEST_F(LodSkippingTab, ShowsIntervalsOverDistanceAndOfWhichClip) {
  driver.report.thresholds = {{8, 2}, {16, 3}};
  scroll_down();
  EXPECT_TRUE(driver.sees("Interval over distance"));
  const int without_clip = driver.overlay.vertex_count();
  driver.report.threshold_clip = "Walking_A";
  driver.frames();
  EXPECT_GT(driver.overlay.vertex_count(), without_clip);
  driver.tuning.lod.rule = LodRule::off;
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

TEST_F(LodSkippingTab, HasTheErrorOnTheScreenBesideTheLimitFromTheFirstFrame) {
  for (const std::uint32_t samples : {0U, 20U, 5000U}) {
    driver.report.error.figures.samples = samples;
    driver.frames();
    for (const char* const figure : {"p50", "p99", "Maximum", "Pop", "Samples", "Error history"}) {
      EXPECT_TRUE(driver.sees(figure)) << figure << " of " << samples << " samples";
    }
  }
}

TEST_F(LodSkippingTab, DrawsHowTheErrorWent) {
  const int before = driver.overlay.vertex_count();
  driver.report.error.p99_history.assign(100, 0.5F);
  driver.frames();
  const int with_p99 = driver.overlay.vertex_count();
  EXPECT_GT(with_p99, before);
  driver.report.error.pop_history.assign(100, 0.2F);
  driver.frames();
  EXPECT_GT(driver.overlay.vertex_count(), with_p99);
}

TEST_F(LodSkippingTab, SaysWhySkippingDoesNotPay) {
  scroll_to_ways_to_look();
  driver.report.error.figures.samples = 1;
  driver.frames();
  const int before = driver.overlay.vertex_count();
  const float place = driver.find("Freeze LOD camera")->y;
  driver.report.error.skipping_sentence = "At 10 frames a second skipping does not pay.";
  driver.frames();
  EXPECT_GT(driver.overlay.vertex_count(), before);
  EXPECT_EQ(driver.find("Freeze LOD camera")->y, place) << "nothing below moves while one clicks at it";
}

TEST_F(LodSkippingTab, ChoosesWhoIsMeasured) {
  driver.click("Measure:all");
  EXPECT_EQ(driver.tuning.error_sample, ErrorSampling::all);
  driver.click("Measure:off");
  EXPECT_EQ(driver.tuning.error_sample, ErrorSampling::off);
}

TEST(ExactCrowd, IsAskedForWhileXIsHeldButNotWhileTyping) {
  OverlayDriver driver;
  const auto hold_x = [&](bool down) {
    driver.input.push({.kind = InputEvent::Kind::key, .key = Key::x, .down = down});
    return asks<ShowExactCrowd>(driver.frames(2));
  };
  EXPECT_TRUE(hold_x(true));
  EXPECT_TRUE(asks<ShowExactCrowd>(driver.frames(2))) << "still held";
  EXPECT_FALSE(hold_x(false));
  driver.click("Agents.field");
  EXPECT_FALSE(hold_x(true)) << "a letter";
}

TEST(ExactCrowd, SkipsAndSimplifiesNothing) {
  Tuning tuning;
  tuning.inspection = {.freeze_camera = true, .forced_interval = 8, .forced_bone_level = 3};
  const Tuning exact = without_level_of_detail(tuning);
  EXPECT_EQ(exact.lod.rule, LodRule::off);
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
  for (const LodRule rule : {LodRule::budget, LodRule::distance}) {
    driver.tuning.lod.rule = rule;
    driver.frames();
    const auto before = driver.tuning.lod.level_distances;
    driver.drag("Level 1 from", 0.9F);
    driver.drag("Level band", 0.2F);
    EXPECT_EQ(driver.tuning.lod.level_distances == before, rule == LodRule::budget);
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
