// The search over the values of all tabs.
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/settings/tuning_values.h"
#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::search_test {
namespace {

/// Prices of the cost model, which files alone set.
constexpr std::array<std::string_view, 6> without_row = {"cost_tile_ns",           "cost_tile_packet_ns",
                                                         "cost_agent_ns",          "cost_player_packet_ns",
                                                         "cost_blender_packet_ns", "cost_post_process_ns"};

struct Search : testing::Test {
  Search() { driver.report.situation.selected = true; }

  void search(const std::string& words) {
    driver.type("/");
    driver.type(words);
  }
  void leave() {
    driver.press(Key::escape);
    ASSERT_FALSE(driver.overlay.ui_map().typing);
  }
  [[nodiscard]] std::vector<std::string> found() const {
    std::vector<std::string> labels;
    for (const auto& [name, place] : driver.overlay.ui_map().widgets) {
      if (name.ends_with(".label")) labels.push_back(name.substr(0, name.size() - 6));
    }
    return labels;
  }
  [[nodiscard]] std::vector<std::string> controls_of(const std::string& label) const {
    std::vector<std::string> controls;
    for (const auto& [name, place] : driver.overlay.ui_map().widgets) {
      if (name == label || name.starts_with(label + ":")) controls.push_back(name);
    }
    return controls;
  }
  // A click at a control is a change, unless it is where the value stands.
  bool changes_by_a_click(const TuningValue& value, const std::string& label) {
    for (const std::string& control : controls_of(label)) {
      const std::string before = value.text(driver.tuning);
      driver.drag(control, 0.6F);
      if (value.text(driver.tuning) != before) return true;
    }
    return false;
  }

  OverlayDriver driver;
};

TEST_F(Search, FindsTheRowOfEveryKeyAndTheRowEditsIt) {
  for (const TuningValue& value : tuning_values()) {
    if (std::ranges::count(without_row, value.key) > 0) continue;
    bool found_right_one = false;
    for (const DebugView view :
         {DebugView::speed, DebugView::density, DebugView::presence}) {  // each leaves others idle
      driver.tuning = {};
      driver.tuning.lod.rule = view == DebugView::speed ? LodRule::distance : LodRule::budget;
      driver.tuning.debug_view = view;
      driver.tuning.wardrobe = value.key == "weather";
      driver.tuning.scene = value.key == "trail_seconds" ? Scene::tracks : Scene::plaza;
      driver.tuning.inspection.forced_interval = value.key == "force_selected_only" ? 2 : 0;
      driver.frames();
      search(std::string(value.key));
      const std::vector<std::string> rows = found();
      EXPECT_FALSE(rows.empty()) << value.key;
      if (!rows.empty()) found_right_one = found_right_one || changes_by_a_click(value, rows.front());
      leave();
    }
    EXPECT_TRUE(found_right_one) << value.key;
  }
}

TEST_F(Search, AFoundValueIsEditedAndResetAndCtrlZAsksForUndo) {
  search("error_px");
  ASSERT_THAT(found(), testing::ElementsAre("Error limit", "Mesh error"));
  const Tuning before = driver.tuning;
  driver.click("Error limit.field");
  driver.type("2.5");
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.error_px, 2.5F);
  driver.hold(Key::control);
  EXPECT_TRUE(asks<Undo>(driver.press(Key::z)));
  driver.let_go(Key::control);
  driver.frames();
  driver.click("Error limit.reset");
  EXPECT_EQ(driver.tuning, before);
}

TEST_F(Search, HasEveryWordInAnyOrderAndCaseAndNamesComeFirst) {
  search("LIMIT error");
  ASSERT_FALSE(found().empty());
  EXPECT_EQ(found().front(), "Error limit");
  EXPECT_THAT(found(), testing::Not(testing::Contains("Time limit"))) << "it speaks of no error";
  EXPECT_THAT(found(), testing::Contains("Mesh error")) << "its explanation has both";
}

TEST_F(Search, ShowsRowsWhereTheTitleOfTheirSectionHasTheWord) {
  search("roles");
  EXPECT_THAT(found(), testing::Contains("Walk"));
  EXPECT_THAT(found(), testing::Not(testing::Contains("Scene")));
}

TEST_F(Search, OffersPartsOfTheBodyWhoseListIsClosed) {
  driver.report.body.bones = {"ankle"};
  search("right foot");
  EXPECT_THAT(found(), testing::Contains("Right foot"));
}

TEST_F(Search, TheNameOfATabLeadsThere) {
  search("error_px");
  driver.click("found:LOD skipping/Rule");
  EXPECT_EQ(driver.overlay.ui_map().tab, "LOD skipping");
  EXPECT_TRUE(driver.sees("Rule.label"));
  EXPECT_FALSE(driver.sees("found:LOD skipping/Rule"));
}

TEST_F(Search, EnterGoesToTheOnlyOneFound) {
  search("mesh_error_px");
  driver.press(Key::enter);
  EXPECT_EQ(driver.overlay.ui_map().tab, "Per-bone LOD");
  EXPECT_TRUE(driver.sees("Mesh error.label"));
  EXPECT_TRUE(driver.sees("Mesh LOD.label")) << "the whole tab";
}

TEST_F(Search, AClickOnATabEndsIt) {
  search("error");
  driver.click("tab:Scheduling");
  EXPECT_EQ(driver.overlay.ui_map().tab, "Scheduling");
  EXPECT_TRUE(driver.sees("Tile.label"));
}

TEST_F(Search, EscEmptiesItBeforeItClosesAnythingElse) {
  driver.press(Key::f1);
  search("error");
  EXPECT_FALSE(asks<Quit>(driver.press(Key::escape)));
  EXPECT_TRUE(driver.sees("Scene.label")) << "from within the field";
  search("error");
  driver.press(Key::enter);
  EXPECT_FALSE(driver.overlay.ui_map().typing);
  EXPECT_FALSE(asks<Quit>(driver.press(Key::escape)));
  EXPECT_TRUE(driver.sees("Scene.label"));
  EXPECT_TRUE(driver.overlay.ui_map().help);
  driver.press(Key::escape);
  EXPECT_FALSE(driver.overlay.ui_map().help);
}

TEST_F(Search, CtrlFAndASlashPutTheCursorIntoItAndDoNothingElse) {
  driver.hold(Key::control);
  EXPECT_FALSE(asks<FrameCrowd>(driver.press(Key::f)));
  driver.let_go(Key::control);
  driver.frames();
  EXPECT_TRUE(driver.overlay.ui_map().typing);
  driver.press(Key::escape);
  EXPECT_FALSE(driver.overlay.ui_map().typing);
  driver.hold(Key::digit_7);  // with Shift it is a slash on some keyboards
  driver.type("/");
  driver.let_go(Key::digit_7);
  EXPECT_FALSE(asks<GoToBookmark>(driver.frames()));
  EXPECT_TRUE(driver.overlay.ui_map().typing);
  driver.type("seed");
  EXPECT_THAT(found(), testing::Contains("Seed")) << "the slash is no part of the text";
}

TEST_F(Search, SaysWhatToDoWhereNothingIsFound) {
  search("xyzzy");
  EXPECT_TRUE(found().empty());
  EXPECT_TRUE(driver.sees("nothing found"));
  leave();
  EXPECT_TRUE(driver.sees("Scene.label"));
}

// Plots and lists that a tab draws by hand cost nothing while values are searched.
TEST_F(Search, DrawsNothingThatIsNoRow) {
  search("xyzzy");
  const int with_little = driver.overlay.vertex_count();
  driver.report.cast = {{.share = 1}, {.share = 1}};
  driver.report.preset_names = {"far"};
  driver.report.crowd_names = {"near"};
  driver.report.sweep.stops = {{.value = 1, .known = true}, {.value = 2, .known = true}};
  driver.report.lod.predicted_ms = 1;
  driver.report.agents_by_interval.assign(16, 60);
  driver.report.bones.resize(100);
  driver.report.timeline.resize(4, driver.report.timeline.front());
  driver.report.error.skipping_sentence = "Skipping does not pay.";
  driver.report.body.follows = "Feet are not placed.";
  driver.frames();
  EXPECT_EQ(driver.overlay.vertex_count(), with_little);
}

}  // namespace
}  // namespace throng::app::search_test
