#include "app/window/panel/overlay.h"

#include <array>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::overlay_test {
namespace {

constexpr std::array tabs = {"Crowd", "LOD skipping", "Per-bone LOD", "Scheduling", "Agent", "Presets"};

TEST(Overlay, AClickOnATabShowsIt) {
  OverlayDriver driver;
  for (const std::string tab : {"Scheduling", "Agent", "LOD skipping", "Presets", "Per-bone LOD", "Crowd"}) {
    driver.click("tab:" + tab);
    EXPECT_EQ(driver.overlay.ui_map().tab, tab);
  }
}

TEST(Overlay, LeavesTheCrowdItsPlace) {
  OverlayDriver driver;
  const UiRectangle crowd = driver.overlay.crowd_area();
  EXPECT_GE(crowd.width, 880);
  EXPECT_GE(crowd.height, 560);
  for (const std::string tab : tabs) {
    driver.click("tab:" + tab);
    for (const auto& [name, place] : driver.overlay.ui_map().widgets) {
      if (name.starts_with("warning:")) continue;
      EXPECT_TRUE(place.x >= crowd.width || place.y >= crowd.height) << name << " lies over the crowd";
      EXPECT_LE(place.x + place.width, OverlayDriver::width) << name;
      EXPECT_LE(place.y + place.height, OverlayDriver::height) << name;
    }
  }
}

TEST(Overlay, LeavesValuesThatThePersonDoesNotTouchAlone) {
  OverlayDriver driver;
  driver.tuning.seed = 4'000'000'000U;
  driver.tuning.agents = 123'456;
  driver.tuning.lod.full_rate_distance = 333.333F;
  set_local_store_kib(driver.tuning, 48);
  driver.tuning.system.tile = 2;
  driver.tuning.lod.level_distances[0] = 500;
  const Tuning before = driver.tuning;
  for (const std::string tab : tabs) {
    driver.click("tab:" + tab);
    driver.frames(20);
  }
  EXPECT_EQ(driver.tuning, before);
}

TEST(Overlay, DraggingATrackMovesItsValueToTheEnds) {
  OverlayDriver driver;
  driver.drag("Agents", 1);
  EXPECT_EQ(driver.tuning.agents, 100'000);
  driver.drag("Agents", 0);
  EXPECT_EQ(driver.tuning.agents, 1);
  driver.click("Agents");
  EXPECT_NEAR(driver.tuning.agents, 316, 20) << "the middle of a logarithmic track";
}

TEST(Overlay, ATypedNumberIsTakenWithEnter) {
  OverlayDriver driver;
  driver.click("Agents.field");
  EXPECT_TRUE(driver.overlay.ui_map().typing);
  driver.type("2,500");
  EXPECT_EQ(driver.tuning.agents, Tuning().agents) << "not before it is whole";
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.agents, 2500);
  EXPECT_FALSE(driver.overlay.ui_map().typing);
}

TEST(Overlay, ATypedNumberIsTakenWhenAnotherFieldIsClicked) {
  OverlayDriver driver;
  driver.click("Speed.field");
  driver.type("2.5");
  driver.click("Agents.field");
  EXPECT_EQ(driver.tuning.time_scale, 2.5F);
}

TEST(Overlay, ATypedNumberStaysInItsRangeAndNonsenseChangesNothing) {
  OverlayDriver driver;
  driver.click("Agents.field");
  driver.type("900000000");
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.agents, 100'000);
  driver.click("Agents.field");
  driver.type("many");
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.agents, 100'000);
}

TEST(Overlay, AChangedValueGoesBackByDoubleClickOrByItsArrow) {
  for (const std::string place : {"Agents", "Agents.label"}) {
    OverlayDriver driver;
    driver.tuning.agents = 7;
    driver.double_click(place);
    EXPECT_EQ(driver.tuning.agents, Tuning().agents) << place;
  }
  OverlayDriver driver;
  EXPECT_FALSE(driver.sees("Agents.reset"));
  driver.tuning.agents = 7;
  driver.frames();
  ASSERT_TRUE(driver.sees("Agents.reset"));
  driver.click("Agents.reset");
  EXPECT_EQ(driver.tuning.agents, Tuning().agents);
}

TEST(Overlay, AnotherClipForARoleIsLookedAtFirstKeptAndTakenBack) {
  OverlayDriver driver;
  driver.point_at(1100, 400);
  driver.frames();
  driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = -100});
  driver.frames();
  ASSERT_TRUE(driver.sees("Walk"));
  EXPECT_FALSE(driver.sees("Walk:Running_A")) << "the list is closed";
  driver.click("Walk");
  ASSERT_TRUE(driver.sees("Walk:Running_A"));
  const Requests picked = driver.click("Walk:Running_A");
  EXPECT_FALSE(asks<SetRoles>(picked)) << "the crowd does not play it yet";
  const ViewRequest looked_at = asked<View>(picked).what;
  ASSERT_TRUE(looked_at.preview);
  EXPECT_EQ(looked_at.preview->role, Role::walk);
  EXPECT_EQ(looked_at.preview->clip, 2);
  driver.click("Walk");
  const auto none = asked<SetRoles>(driver.click("Walk:none"));  // there is nothing to look at
  EXPECT_EQ(none.clips[index_of(Role::walk)], no_clip);
  EXPECT_EQ(none.clips[index_of(Role::stand)], 0);
  EXPECT_TRUE(asks<SaveRoles>(driver.click("Save roles")));
  EXPECT_EQ(asked<SetRoles>(driver.click("Reset roles")).clips[index_of(Role::walk)], 1);
}

TEST(Overlay, OfSeveralCharactersOneIsChosenToShowItsRoles) {
  OverlayDriver driver;
  EXPECT_FALSE(driver.sees("Model:knight.glb")) << "one character is a fact";
  driver.report.characters = {"models/person.glb", "models/knight.glb"};
  driver.frames();
  driver.click("Model");
  ASSERT_TRUE(driver.sees("Model:knight.glb"));
  EXPECT_EQ(asked<ShowCharacter>(driver.click("Model:knight.glb")).character, 1U);
}

TEST(Overlay, EveryChoiceCanBeMade) {
  OverlayDriver driver;
  driver.click("Scene:grid");
  EXPECT_EQ(driver.tuning.scene, Scene::grid);
  driver.click("Colours:bones");
  EXPECT_EQ(driver.tuning.debug_view, DebugView::bone_level);
  driver.click("tab:LOD skipping");
  driver.click("Rule:off");
  EXPECT_EQ(driver.tuning.lod.rule, LodRule::off);
  driver.click("tab:Per-bone LOD");
  driver.click("Mesh LOD:2");
  EXPECT_EQ(driver.tuning.mesh_lod, 2);
  driver.click("Per-bone LOD");
  EXPECT_FALSE(driver.tuning.lod.bone_lod);
  driver.click("tab:Scheduling");
  driver.click("Schedule:levels");
  EXPECT_EQ(driver.tuning.system.schedule, anim::Schedule::levels);
  driver.click("Double buffer:inline");
  EXPECT_EQ(driver.tuning.system.double_buffering, anim::DoubleBuffering::inline_copy);
  driver.click("Stream:keyframe");
  EXPECT_EQ(driver.tuning.system.stream, anim::StreamKind::keyframe);
}

TEST(Overlay, ProcessingUnitsAndStoresCanBeChangedAndGoBackToTheirWord) {
  OverlayDriver driver;
  driver.click("tab:Scheduling");
  driver.drag("PUs", 1);
  EXPECT_EQ(driver.tuning.system.pus, 16);
  driver.drag("Local store", 1);
  EXPECT_EQ(local_store_kib(driver.tuning), 1024);
  driver.click("Local store.field");
  driver.type("auto");
  driver.press(Key::enter);
  EXPECT_EQ(local_store_kib(driver.tuning), 0);
  driver.click("Tile.field");
  driver.type("5");
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.system.tile, 4) << "the nearest that there is";
}

TEST(Overlay, BoneLevelsFollowEachOther) {
  OverlayDriver driver;
  driver.click("tab:Per-bone LOD");
  driver.tuning.lod.rule = LodRule::distance;
  driver.drag("Level 1 from", 1);
  const auto& distance = driver.tuning.lod.level_distances;
  EXPECT_EQ(distance[0], 150);
  EXPECT_GE(distance[1], distance[0]);
  EXPECT_GE(distance[2], distance[1]);
  driver.drag("Level 3 from", 0);
  EXPECT_EQ(distance[0], 0);
}

TEST(Overlay, ShowsNoMoreBoneLevelsThanTheCharacterHas) {
  OverlayDriver driver;
  driver.click("tab:Per-bone LOD");
  EXPECT_TRUE(driver.sees("Level 3 from"));
  driver.report.level_bone_counts = {62, 20};
  driver.frames();
  EXPECT_TRUE(driver.sees("Level 1 from"));
  EXPECT_FALSE(driver.sees("Level 2 from"));
}

TEST(Overlay, ABorderOfTheLevelBandCanBeDragged) {
  OverlayDriver driver;
  driver.click("tab:Per-bone LOD");
  driver.tuning.lod.rule = LodRule::distance;
  driver.drag("Level band", 0.8F);  // from the middle, 75 m, which is nearest to level 3 at 60 m
  EXPECT_NEAR(driver.tuning.lod.level_distances[2], 120, 1);
  EXPECT_EQ(driver.tuning.lod.level_distances[1], Tuning().lod.level_distances[1]);
}

TEST(Overlay, ValuesOfASwitchedOffRuleCannotBeMoved) {
  OverlayDriver driver;
  driver.tuning.lod.rule = LodRule::off;
  driver.click("tab:LOD skipping");
  driver.drag("Largest interval", 1);
  EXPECT_EQ(driver.tuning.lod.largest_interval, Tuning().lod.largest_interval);
}

TEST(Overlay, ButtonsAskForWhatTheySay) {
  OverlayDriver driver;
  driver.point_at("Agents", 0.5F);
  driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = -2});
  driver.frames();
  EXPECT_TRUE(asks<CopyCamera>(driver.click("Copy camera")));
  EXPECT_TRUE(asks<TakeScreenshot>(driver.click("Screenshot")));
  EXPECT_FALSE(asks<StepFrame>(driver.click("Step"))) << "the crowd is not paused";
  driver.click("Pause");
  EXPECT_TRUE(driver.tuning.paused);
  EXPECT_TRUE(asks<StepFrame>(driver.click("Step")));
}

TEST(Overlay, KeysAskForWhatTheHelpSays) {
  OverlayDriver driver;
  driver.press(Key::space);
  EXPECT_TRUE(driver.tuning.paused);
  driver.press(Key::space);
  EXPECT_FALSE(driver.tuning.paused);
  EXPECT_TRUE(asks<FrameCrowd>(driver.press(Key::f)));
  EXPECT_TRUE(asks<CopyCamera>(driver.press(Key::c)));
  EXPECT_TRUE(asks<TakeScreenshot>(driver.press(Key::f12)));
  EXPECT_TRUE(asks<ReloadShaders>(driver.press(Key::f5)));
  EXPECT_TRUE(asks<Quit>(driver.press(Key::escape)));
}

TEST(Overlay, KeysAreLettersWhileTyping) {
  OverlayDriver driver;
  driver.click("Agents.field");
  for (const Key key : {Key::space, Key::tab, Key::f, Key::f12}) {
    const Requests requests = driver.press(key);
    EXPECT_FALSE(asks<FrameCrowd>(requests) || asks<TakeScreenshot>(requests));
  }
  EXPECT_FALSE(driver.tuning.paused);
  EXPECT_FALSE(driver.overlay.ui_map().hidden);
  EXPECT_FALSE(asks<Quit>(driver.press(Key::escape))) << "the first Esc leaves the field";
  EXPECT_TRUE(asks<Quit>(driver.press(Key::escape)));
}

TEST(Overlay, TabHidesAllOfItAndBringsItBack) {
  OverlayDriver driver;
  EXPECT_GT(driver.overlay.vertex_count(), 0);
  driver.press(Key::tab);
  EXPECT_EQ(driver.overlay.vertex_count(), 0);
  EXPECT_EQ(driver.overlay.crowd_area().width, 1280);
  driver.press(Key::tab);
  EXPECT_GT(driver.overlay.vertex_count(), 0);
}

TEST(Overlay, F1ShowsTheHelpCard) {
  OverlayDriver driver;
  driver.press(Key::f1);
  EXPECT_TRUE(driver.overlay.ui_map().help);
  EXPECT_TRUE(driver.sees("Help"));
  driver.press(Key::f1);
  EXPECT_FALSE(driver.sees("Help"));
}

TEST(Overlay, ThePointerBelongsToTheCameraOverTheCrowdOnly) {
  OverlayDriver driver;
  driver.point_at(450, 300);
  driver.frames();
  EXPECT_FALSE(driver.overlay.uses_pointer());
  driver.point_at(1100, 300);
  driver.frames();
  EXPECT_TRUE(driver.overlay.uses_pointer());
}

TEST(Overlay, TextGoesToTheClipboardAndComesFromIt) {
  OverlayDriver driver;
  driver.click("Agents.field");
  driver.input.push({.kind = InputEvent::Kind::key, .key = Key::control, .down = true});
  driver.press(Key::c);
  EXPECT_EQ(driver.clipboard, "1,000");
  driver.clipboard = "64";
  driver.press(Key::v);
  driver.input.push({.kind = InputEvent::Kind::key, .key = Key::control, .down = false});
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.agents, 64);
}

TEST(Overlay, ShowsAReportInWhichThereIsNothing) {
  OverlayDriver driver;
  driver.report = {};
  for (const std::string tab : tabs) {
    driver.click("tab:" + tab);
    EXPECT_GT(driver.overlay.vertex_count(), 0) << tab;
  }
}

TEST(Overlay, WorksWithoutItsFontsAndSaysSo) {
  OverlayDriver driver("/nowhere");
  EXPECT_TRUE(driver.sees("warning:1")) << "it follows the warning of the report";
  EXPECT_GT(driver.overlay.vertex_count(), 0);
  EXPECT_FALSE(OverlayDriver().sees("warning:1"));
}

TEST(Overlay, ShowsTheNoticeOfTheReport) {
  OverlayDriver driver;
  driver.frames();
  const int with_notice = driver.overlay.vertex_count();
  driver.report.notice.clear();
  driver.frames();
  EXPECT_LT(driver.overlay.vertex_count(), with_notice);
}

TEST(Overlay, ShowsEachLineOfTheNoticeByItself) {
  OverlayDriver driver;
  driver.report.notice = "one two";
  driver.frames();
  const int on_one_line = driver.overlay.vertex_count();
  driver.report.notice = "one\ntwo";
  driver.frames();
  EXPECT_GT(driver.overlay.vertex_count(), on_one_line);
}

}  // namespace
}  // namespace throng::app::overlay_test
