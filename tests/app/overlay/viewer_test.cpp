// The panel of the viewer of one character.

#include <gtest/gtest.h>

#include "tests/app/overlay/overlay_driver.h"

namespace throng::app::viewer_panel_test {
namespace {

ViewerReport two_clips() {
  return {.clips = {{"Idle", 2.0F, true}, {"Walking_A", 1.03F, true}, {"Running_A", 0.7F, true}},
          .length = 2.0F,
          .height = 1.8F,
          .reach = 1.2F,
          .level_bones = {4, 3, 2, 1},
          .meshes = {{1000, 0.0F}, {200, 0.01F}}};
}

struct ViewerPanel : testing::Test {
  ViewerPanel() {
    driver.report.viewer = two_clips();
    driver.frames();
  }
  OverlayDriver driver;
};

TEST_F(ViewerPanel, TakesThePlaceOfTheTabs) {
  EXPECT_TRUE(driver.sees("Clip:Walking_A"));
  EXPECT_FALSE(driver.sees("tab:Crowd"));
  EXPECT_TRUE(driver.click("Back to the crowd").viewer.leave);
  driver.report.viewer.reset();
  driver.frames();
  EXPECT_TRUE(driver.sees("tab:Crowd"));
}

TEST_F(ViewerPanel, HasNoStripThatCoversTheCharacter) {
  EXPECT_EQ(driver.overlay.crowd_area().height, OverlayDriver::height);
  EXPECT_EQ(driver.overlay.crowd_area().width, 900);
  driver.report.viewer.reset();
  driver.frames();
  EXPECT_EQ(driver.overlay.crowd_area().height, OverlayDriver::height - 132);
}

TEST_F(ViewerPanel, AClickAtAClipChoosesIt) {
  const auto chosen = driver.click("Clip:Walking_A").viewer.settings;
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->clip, 1);
}

TEST_F(ViewerPanel, FindsClipsByAPartOfTheirNames) {
  driver.click("Search clips.field");
  driver.type("RUN");
  EXPECT_FALSE(driver.sees("Clip:Walking_A"));
  EXPECT_TRUE(driver.sees("Clip:Running_A"));
}

TEST_F(ViewerPanel, ADragAlongTheTimeHoldsTheClipThere) {
  driver.drag("At", 0.5F);
  driver.point_at(600, 600);
  EXPECT_FALSE(driver.frames().viewer.scrub) << "nobody drags any more";
}

TEST_F(ViewerPanel, SpaceStopsTheClipAndNotTheCrowd) {
  const auto paused = driver.press(Key::space).viewer.settings;
  ASSERT_TRUE(paused);
  EXPECT_FALSE(paused->plays);
  EXPECT_FALSE(driver.tuning.paused);
}

TEST_F(ViewerPanel, EscGoesBackToTheCrowdBeforeItQuits) {
  const OverlayCommands commands = driver.press(Key::escape);
  EXPECT_TRUE(commands.viewer.leave);
  EXPECT_FALSE(commands.quit);
}

TEST_F(ViewerPanel, AsksTheCrowdForNothing) {
  driver.report.selected = SelectionReport{.entities = {}};
  const OverlayCommands keys = [&] {
    OverlayCommands all = driver.press(Key::r);
    all.push_over |= driver.press(Key::p).push_over;
    return all;
  }();
  EXPECT_FALSE(keys.record);
  EXPECT_FALSE(keys.push_over);
  driver.point_at(300, 300);
  driver.input.push({.kind = InputEvent::Kind::button, .down = true});
  driver.input.push({.kind = InputEvent::Kind::button, .down = false});
  EXPECT_FALSE(driver.frames().select_at);
}

TEST_F(ViewerPanel, OffersTheLevelsThatThereAre) {
  const auto level = driver.click("Bone level:3").viewer.settings;
  ASSERT_TRUE(level);
  EXPECT_EQ(level->bone_level, 3);
  EXPECT_TRUE(driver.sees("Mesh LOD:1"));
  EXPECT_FALSE(driver.sees("Mesh LOD:2")) << "there is no such mesh";
}

TEST_F(ViewerPanel, OfAClipForARoleAsksBeforeTheCrowdPlaysIt) {
  EXPECT_FALSE(driver.sees("Apply to the crowd"));
  driver.report.viewer->preview = RolePreview{Role::walk, 1};
  driver.frames();
  EXPECT_TRUE(driver.click("Apply to the crowd").viewer.apply_preview);
}

TEST(CharacterOfTheCrowd, IsViewedWithoutASelection) {
  OverlayDriver driver;
  driver.report.character = 1;
  driver.report.characters = {"a.glb", "b.glb"};
  driver.frames();
  const auto view = driver.click("View model").viewer.view;
  ASSERT_TRUE(view);
  EXPECT_EQ(view->character, 1U);
}

TEST(SelectedAgent, IsViewedByAButtonOfItsCard) {
  OverlayDriver driver;
  driver.report.selected = SelectionReport{.entities = {}};
  driver.frames();
  EXPECT_TRUE(driver.click("View").viewer.view_selected);
}

}  // namespace
}  // namespace throng::app::viewer_panel_test
