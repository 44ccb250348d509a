// The panel by keyboard alone.
#include <algorithm>
#include <array>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::keyboard_test {
namespace {

struct Keyboard : testing::Test {
  Keyboard() { driver.press(Key::f6); }

  [[nodiscard]] const std::string& focus() const { return driver.overlay.ui_map().focus; }

  /// Goes down until that widget has the focus.
  void go_to(const std::string& widget) {
    for (int i = 0; i < 300 && focus() != widget; ++i) driver.press(Key::down);
    ASSERT_EQ(focus(), widget);
  }
  Requests press_with(Key held, Key key) {
    driver.hold(held);
    Requests requests = driver.press(key);
    driver.let_go(held);
    driver.frames();
    return requests;
  }

  struct Walk {
    std::set<std::string> visited, clickable;

    void see(const OverlayDriver& driver) {
      visited.insert(driver.overlay.ui_map().focus);
      for (const auto& [name, place] : driver.overlay.ui_map().widgets) {
        if (place.takes_clicks) clickable.insert(name);
      }
    }
    /// Enter goes from a number into its field, and left and right go through the words of a choice.
    [[nodiscard]] bool reaches(const std::string& name) const {
      if (visited.contains(name)) return true;
      if (name.ends_with(".field") && visited.contains(name.substr(0, name.size() - 6))) return true;
      const std::string row = name.substr(0, name.find(':') + 1);
      const auto is_of_row = [&](const std::string& each) { return each.starts_with(row); };
      const std::array<std::string, 7> no_rows = {"", "tab:", "header:", "badge:", "warning:", "message:", "found:"};
      return std::ranges::count(no_rows, row) == 0 && std::ranges::any_of(visited, is_of_row);
    }
  };
  Walk walk_round() {
    Walk walk;
    const std::string first = focus();
    do {
      driver.press(Key::down);
      walk.see(driver);
    } while (focus() != first && walk.visited.size() < 400);
    return walk;
  }
  void expect_all_are_reached(const std::string& where) {
    const Walk walk = walk_round();
    EXPECT_GT(walk.visited.size(), 12U) << where;
    for (const std::string& name : walk.clickable) EXPECT_TRUE(walk.reaches(name)) << where << ": " << name;
    EXPECT_FALSE(walk.visited.contains("")) << where;
  }

  OverlayDriver driver;
};

TEST_F(Keyboard, ComesAndGoesByF6AndEscAndABadgeSaysSo) {
  EXPECT_EQ(focus(), "Scene:plaza") << "the first row";
  EXPECT_TRUE(driver.sees("badge:keys"));
  driver.press(Key::f6);
  EXPECT_EQ(focus(), "");
  EXPECT_FALSE(driver.sees("badge:keys"));
  driver.press(Key::f6);
  EXPECT_FALSE(asks<Quit>(driver.press(Key::escape)));
  EXPECT_EQ(focus(), "");
  EXPECT_TRUE(asks<Quit>(driver.press(Key::escape)));
}

TEST_F(Keyboard, StaysWhereItWasWhenItComesBack) {
  go_to("Seed");
  driver.press(Key::f6);
  driver.press(Key::f6);
  EXPECT_EQ(focus(), "Seed");
}

TEST_F(Keyboard, AClickAtTheCrowdGivesItBackAndAClickAtAWidgetTakesItThere) {
  driver.click("Variety");
  EXPECT_EQ(focus(), "Variety");
  driver.point_at(450, 300);
  driver.button(true);
  driver.button(false);
  driver.frames();
  EXPECT_EQ(focus(), "");
}

TEST_F(Keyboard, ReachesEveryWidgetOfEveryTab) {
  driver.report.preset_names = {"far"};
  driver.report.crowd_names = {"near"};
  for (const std::string tab : {"Crowd", "LOD skipping", "Per-bone LOD", "Scheduling", "Agent", "Presets"}) {
    EXPECT_EQ(driver.overlay.ui_map().tab, tab);
    expect_all_are_reached(tab);
    press_with(Key::control, Key::page_down);
  }
}

TEST_F(Keyboard, ReachesBadgesCardsAndTheReplay) {
  driver.tuning.inspection.freeze_camera = true;
  driver.report.replay = ReplayReport{.frame = 5, .frames = 100};
  driver.report.selected.emplace().can_fall = true;
  driver.press(Key::f1);
  driver.press(Key::l);
  expect_all_are_reached("over the crowd");
  go_to("Help.close");
  driver.press(Key::enter);
  EXPECT_FALSE(driver.overlay.ui_map().help);
  go_to("Selected.fold");
  driver.press(Key::enter);
  EXPECT_FALSE(driver.sees("Deselect"));
  go_to("badge:frozen");
  driver.press(Key::enter);
  EXPECT_FALSE(driver.tuning.inspection.freeze_camera);
  go_to("Replay.track");
  EXPECT_EQ(asked<SeekReplay>(driver.press(Key::right)).frame, 6U);
  go_to("Replay.play");
  const Requests requests = driver.press(Key::space);
  const auto toggles = [](const Request& request) { return as<ToggleReplayPause>(request) != nullptr; };
  EXPECT_EQ(std::ranges::count_if(requests, toggles), 1) << "two would leave it as it was";
}

TEST_F(Keyboard, WalksBothWaysRoundAndToTheEnds) {
  driver.press(Key::home);
  const std::string first = focus();
  driver.press(Key::up);
  const std::string last = focus();
  driver.press(Key::end);
  EXPECT_EQ(focus(), last);
  driver.press(Key::tab);
  EXPECT_EQ(focus(), first);
  press_with(Key::shift, Key::tab);
  EXPECT_EQ(focus(), last);
  EXPECT_TRUE(driver.sees(last)) << "it is scrolled to";
  EXPECT_FALSE(driver.overlay.ui_map().hidden);
}

TEST_F(Keyboard, ANumberIsSteppedTypedAndResetAndCtrlZAsksForUndo) {
  go_to("Seed");
  driver.press(Key::right);
  EXPECT_EQ(driver.tuning.seed, Tuning().seed + 1);
  press_with(Key::shift, Key::right);
  EXPECT_EQ(driver.tuning.seed, Tuning().seed + 11);
  driver.press(Key::left);
  EXPECT_EQ(driver.tuning.seed, Tuning().seed + 10);
  driver.press(Key::enter);
  EXPECT_TRUE(driver.overlay.ui_map().typing);
  driver.type("77");
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.seed, 77U);
  EXPECT_FALSE(driver.overlay.ui_map().typing);
  EXPECT_EQ(focus(), "Seed");
  driver.press(Key::del);
  EXPECT_EQ(driver.tuning.seed, Tuning().seed);
  EXPECT_TRUE(asks<Undo>(press_with(Key::control, Key::z)));
  driver.tuning.seed = 77;
  driver.frames();
  driver.press(Key::down);
  EXPECT_EQ(focus(), "Seed.reset");
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.seed, Tuning().seed);
  EXPECT_EQ(focus(), "Seed") << "its arrow is gone";
}

TEST_F(Keyboard, ATypedNumberIsTakenByTheKeyThatLeavesItsField) {
  go_to("Seed");
  driver.press(Key::enter);
  driver.type("78");
  driver.press(Key::tab);
  EXPECT_EQ(driver.tuning.seed, 78U);
  EXPECT_EQ(focus(), "Variety");
  go_to("Seed");
  driver.press(Key::enter);
  driver.type("79");
  driver.press(Key::escape);
  EXPECT_EQ(driver.tuning.seed, 78U) << "Esc leaves it as it was";
  EXPECT_EQ(focus(), "Seed");
}

TEST_F(Keyboard, AHeldKeyMakesOneChange) {
  go_to("Seed");
  EXPECT_FALSE(driver.overlay.is_in_a_change());
  driver.hold(Key::right);
  for (int frame = 0; frame < 60; ++frame) {
    driver.frames(1);
    EXPECT_TRUE(driver.overlay.is_in_a_change()) << frame;
  }
  EXPECT_GT(driver.tuning.seed, Tuning().seed + 3) << "it repeats";
  driver.let_go(Key::right);
  driver.frames();
  EXPECT_FALSE(driver.overlay.is_in_a_change());
}

TEST_F(Keyboard, SwitchesAndChoicesChangeByArrowsAndByEnter) {
  go_to("Variety");
  driver.press(Key::left);
  EXPECT_FALSE(driver.tuning.variety);
  driver.press(Key::space);
  EXPECT_TRUE(driver.tuning.variety);
  EXPECT_FALSE(driver.tuning.paused) << "Space belongs to the panel";
  go_to("Scene:plaza");
  driver.press(Key::right);
  EXPECT_EQ(driver.tuning.scene, Scene::parade);
  EXPECT_EQ(focus(), "Scene:parade");
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.scene, Scene::stadium);
  driver.press(Key::backspace);
  EXPECT_EQ(driver.tuning.scene, Scene::plaza);
}

TEST_F(Keyboard, AListIsWalkedTakenAndClosed) {
  go_to("Walk");
  driver.press(Key::enter);
  EXPECT_TRUE(driver.sees("Walk:Running_A"));
  driver.press(Key::down);
  const ViewRequest picked = asked<View>(driver.press(Key::enter)).what;
  ASSERT_TRUE(picked.preview);
  EXPECT_EQ(picked.preview->clip, 2);
  EXPECT_FALSE(driver.sees("Walk:Running_A"));
  EXPECT_EQ(focus(), "Walk");
  driver.press(Key::enter);
  driver.press(Key::home);
  EXPECT_FALSE(asks<SetRoles>(driver.press(Key::escape)));
  EXPECT_FALSE(driver.sees("Walk:Running_A"));
  EXPECT_EQ(focus(), "Walk") << "the first Esc closes the list";
}

TEST_F(Keyboard, LettersAndDigitsStayHotkeysAndOthersDoNot) {
  EXPECT_TRUE(asks<ToggleRecording>(driver.press(Key::r)));
  EXPECT_TRUE(asks<GoToBookmark>(driver.press(Key::digit_2)));
  EXPECT_FALSE(asks<GoHome>(driver.press(Key::home)));
  driver.press(Key::space);
  EXPECT_FALSE(driver.tuning.paused);
}

TEST_F(Keyboard, WhatIsIdleIsReachedAndDoesNothing) {
  driver.tuning.lod.rule = LodRule::off;
  press_with(Key::control, Key::tab);
  EXPECT_EQ(driver.overlay.ui_map().tab, "LOD skipping");
  go_to("Largest interval");
  driver.press(Key::right);
  driver.press(Key::enter);
  EXPECT_FALSE(driver.overlay.ui_map().typing);
  EXPECT_EQ(driver.tuning.lod.largest_interval, Tuning().lod.largest_interval);
  EXPECT_EQ(focus(), "Largest interval");
}

TEST_F(Keyboard, ExplainsTheRowWhereItRests) {
  driver.press(Key::down);
  const int before = driver.overlay.vertex_count();
  driver.frames(60);
  EXPECT_GT(driver.overlay.vertex_count(), before);
}

TEST_F(Keyboard, GoesFromTheSearchToWhatIsFound) {
  driver.press(Key::f6);
  driver.type("/");
  driver.type("seed");
  driver.press(Key::down);
  EXPECT_EQ(focus(), "Seed");
  driver.press(Key::right);
  EXPECT_EQ(driver.tuning.seed, Tuning().seed + 1);
  go_to("found:Crowd/Who");
  driver.press(Key::enter);
  EXPECT_TRUE(driver.sees("Agents.label"));
  EXPECT_TRUE(focus().starts_with("Scene:")) << "the first row of the section: " << focus();
}

TEST_F(Keyboard, MovesBonesAndTheEndsOfLevels) {
  driver.report.bones[3].parent = 1;
  driver.report.level_bone_counts = {4, 3, 1};
  press_with(Key::control, Key::tab);
  press_with(Key::control, Key::tab);
  go_to("Bone 2");
  EXPECT_TRUE(asks<SetBones>(driver.press(Key::right)));
  EXPECT_EQ(focus(), "Bone 3") << "the focus goes along";
  go_to("Border 1");
  EXPECT_TRUE(asks<SetBones>(driver.press(Key::left)));
}

TEST_F(Keyboard, LooksAtSlowFramesAndSweepsAndTheTimeline) {
  driver.report.kept.numbers = {390, 420};
  driver.frames();
  go_to("Frame graph");
  EXPECT_EQ(asked<LookAtFrame>(driver.press(Key::enter)).frame, 420);
  driver.report.sweep.value = SweptValue::tile;
  driver.report.sweep.stops = {{.value = 4, .known = true}, {.value = 8, .known = true}};
  driver.tuning.system.tile = 4;
  driver.frames();
  go_to("Sweep curve");
  driver.press(Key::right);
  EXPECT_EQ(driver.tuning.system.tile, 8);
  go_to("Timeline");
  const int all = driver.overlay.vertex_count();
  press_with(Key::shift, Key::right);
  press_with(Key::shift, Key::right);
  EXPECT_NE(driver.overlay.vertex_count(), all);
}

TEST_F(Keyboard, MovesTheSplitLine) {
  driver.tuning.inspection.split = Split::shown;
  driver.frames();
  const float before = driver.tuning.inspection.split_at;
  go_to("split line");
  driver.press(Key::right);
  EXPECT_NEAR(driver.tuning.inspection.split_at, before + 0.01F, 1e-4F);
}

TEST_F(Keyboard, SeesEveryKeyOfASlowFrame) {
  go_to("Seed");
  for (const Key key : {Key::right, Key::down, Key::del}) driver.hold(key);  // in one frame
  driver.frames();
  EXPECT_EQ(driver.tuning.seed, Tuning().seed + 1);
  EXPECT_NE(focus(), "Seed");
}

}  // namespace
}  // namespace throng::app::keyboard_test
