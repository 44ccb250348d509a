// A and B in the tab Presets, and key B.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/settings/tuning_values.h"
#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::pair_test {
namespace {

struct PairTest : testing::Test {
  PairTest() { driver.click("tab:Presets"); }
  TuningPair& pair() { return driver.overlay.tuning_pair(); }
  OverlayDriver driver;
};

TEST_F(PairTest, NothingIsCopiedUntilItIsAskedFor) {
  EXPECT_THAT(asked<Tell>(driver.press(Key::b)).words, testing::HasSubstr("Copy A to B"));
  EXPECT_FALSE(pair().has_two());
  EXPECT_FALSE(driver.overlay.ui_map().shows_b);
  EXPECT_FALSE(driver.sees("badge:pair"));
  EXPECT_NE(driver.why_idle("B"), nullptr) << "there is no B to be named";
  EXPECT_NE(driver.why_idle("Forget B"), nullptr);
  driver.click("Copy A to B");
  EXPECT_TRUE(pair().has_two());
  EXPECT_FALSE(asks<Tell>(driver.press(Key::b)));
  EXPECT_TRUE(driver.overlay.ui_map().shows_b);
}

TEST_F(PairTest, TheyChangePlacesByKeyAndByChoice) {
  driver.click("Copy A to B");
  driver.press(Key::b);
  driver.tuning.agents = 77;
  driver.press(Key::b);
  EXPECT_EQ(driver.tuning.agents, Tuning().agents);
  driver.click("In use:B");
  EXPECT_EQ(driver.tuning.agents, 77);
  EXPECT_TRUE(driver.overlay.ui_map().shows_b);
}

TEST_F(PairTest, OneIsCopiedToTheOther) {
  driver.click("Copy A to B");
  driver.press(Key::b);
  driver.tuning.agents = 77;
  driver.frames();
  driver.click("Copy B to A");
  driver.press(Key::b);
  EXPECT_EQ(driver.tuning.agents, 77);
}

TEST_F(PairTest, EachHasTheNameThatIsTyped) {
  driver.click("Copy A to B");
  driver.click("A.field");
  driver.type("baseline");
  driver.click("B.field");
  driver.type("tight");
  driver.press(Key::enter);
  EXPECT_EQ(pair().title_in_use(), "A: baseline");
  EXPECT_EQ(pair().other_title(), "B: tight");
}

TEST_F(PairTest, SaysInWhichValuesTheyDiffer) {
  driver.click("Copy A to B");
  EXPECT_FALSE(driver.sees("Error limit"));
  driver.tuning.error_px = 4;
  driver.frames();
  EXPECT_TRUE(driver.sees("Error limit")) << "by the name that the panel has for it";
  EXPECT_FALSE(driver.sees("Agents"));
  driver.tuning.paused = true;
  driver.tuning.agents = 77;
  driver.frames();
  EXPECT_TRUE(driver.sees("Agents"));
  EXPECT_FALSE(driver.sees("Pause"));
}

TEST_F(PairTest, ForgettingOneEndsTheComparison) {
  driver.click("Copy A to B");
  driver.press(Key::b);
  pair().names[1] = "tight";
  driver.tuning.agents = 77;
  driver.frames();
  driver.click("Forget A");
  EXPECT_FALSE(driver.sees("badge:pair"));
  EXPECT_FALSE(driver.overlay.ui_map().shows_b);
  EXPECT_EQ(driver.tuning.agents, 77) << "what is in use stays";
  EXPECT_EQ(pair().title_in_use(), "A: tight");
}

TEST_F(PairTest, APresetBecomesTheOtherOne) {
  driver.report.preset_names = {"far"};
  driver.frames();
  EXPECT_EQ(asked<LoadIntoOther>(driver.click("To B far")).preset, "far");
}

TEST_F(PairTest, ReplaysChangeNoPlaces) {
  driver.click("Copy A to B");
  driver.report.replay.emplace();
  driver.press(Key::b);
  EXPECT_FALSE(driver.overlay.ui_map().shows_b);
}

TEST_F(PairTest, BIsALetterWhileTyping) {
  driver.click("Copy A to B");
  driver.click("Name.field");
  driver.press(Key::b);
  EXPECT_FALSE(driver.overlay.ui_map().shows_b);
}

// Scrolls through all tabs and notes the rows.
std::string all_rows(OverlayDriver& driver) {
  std::string rows;
  const auto add = [&] {
    for (const auto& [name, place] : driver.overlay.ui_map().widgets) rows += "\n" + name + "\n";
  };
  for (const std::string tab : {"Crowd", "LOD skipping", "Per-bone LOD", "Scheduling"}) {
    driver.click("tab:" + tab);
    driver.point_at(1100, 600);
    driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = 200});
    driver.frames();
    for (int pages = 0; pages < 8; ++pages) {
      add();
      driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = -5});
      driver.frames();
    }
  }
  return rows;
}

TEST_F(PairTest, ValuesAreCalledAsTheRowsThatShowThem) {
  std::string rows;
  for (const DebugView view : {DebugView::speed, DebugView::density, DebugView::presence}) {
    driver.tuning.debug_view = view;
    driver.tuning.lod.rule = view == DebugView::speed ? LodRule::distance : LodRule::budget;
    rows += all_rows(driver);
  }
  for (const TuningValue& value : tuning_values()) {
    const std::string label = value.label;
    if (label.empty()) continue;
    EXPECT_THAT(rows, testing::HasSubstr("\n" + label + ".label\n")) << value.key;
  }
}

}  // namespace
}  // namespace throng::app::pair_test
