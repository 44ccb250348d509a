// The panel of the viewer of one character.

#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

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
  EXPECT_TRUE(asks<LeaveViewer>(driver.click("Back to the crowd")));
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
  EXPECT_EQ(asked<SetViewer>(driver.click("Clip:Walking_A")).settings.clip, 1);
}

TEST_F(ViewerPanel, FindsClipsByAPartOfTheirNames) {
  driver.click("Search clips.field");
  driver.type("RUN");
  EXPECT_FALSE(driver.sees("Clip:Walking_A"));
  EXPECT_TRUE(driver.sees("Clip:Running_A"));
}

TEST_F(ViewerPanel, ADragAlongTheTimeHoldsTheClipThere) {
  driver.point_at("At", 0.5F);
  driver.button(true);
  EXPECT_NEAR(asked<ScrubViewer>(driver.frames()).seconds, 1, 0.05) << "the middle of two seconds";
  driver.button(false);
  driver.point_at(600, 600);
  driver.frames();
  EXPECT_FALSE(asks<ScrubViewer>(driver.frames())) << "the drag has ended";
}

TEST_F(ViewerPanel, SpaceStopsTheClipAndNotTheCrowd) {
  EXPECT_FALSE(asked<SetViewer>(driver.press(Key::space)).settings.plays);
  EXPECT_FALSE(driver.tuning.paused);
}

TEST_F(ViewerPanel, EscGoesBackToTheCrowdBeforeItQuits) {
  const Requests requests = driver.press(Key::escape);
  EXPECT_TRUE(asks<LeaveViewer>(requests));
  EXPECT_FALSE(asks<Quit>(requests));
}

TEST_F(ViewerPanel, AsksTheCrowdForNothing) {
  driver.report.selected = SelectionReport{.entities = {}};
  EXPECT_FALSE(asks<ToggleRecording>(driver.press(Key::r)));
  EXPECT_FALSE(asks<Push>(driver.press(Key::p)));
  driver.hold(Key::control);
  EXPECT_FALSE(asks<Undo>(driver.press(Key::z)));
  driver.let_go(Key::control);
  driver.point_at(300, 300);
  driver.input.push({.kind = InputEvent::Kind::button, .down = true});
  driver.input.push({.kind = InputEvent::Kind::button, .down = false});
  EXPECT_FALSE(asks<SelectAt>(driver.frames()));
}

TEST_F(ViewerPanel, OffersTheLevelsThatThereAre) {
  EXPECT_EQ(asked<SetViewer>(driver.click("Bone level:3")).settings.bone_level, 3);
  EXPECT_TRUE(driver.sees("Mesh LOD:1"));
  EXPECT_FALSE(driver.sees("Mesh LOD:2")) << "there is no such mesh";
}

TEST_F(ViewerPanel, OfAClipForARoleAsksBeforeTheCrowdPlaysIt) {
  EXPECT_FALSE(driver.sees("Apply to the crowd"));
  driver.report.viewer->preview = RolePreview{Role::walk, 1};
  driver.frames();
  EXPECT_TRUE(asks<ApplyPreview>(driver.click("Apply to the crowd")));
}

TEST(CharacterOfTheCrowd, IsViewedWithoutASelection) {
  OverlayDriver driver;
  driver.report.character = 1;
  driver.report.characters = {"a.glb", "b.glb"};
  driver.frames();
  EXPECT_EQ(asked<View>(driver.click("View model")).what.character, 1U);
}

TEST(SelectedAgent, IsViewedByAButtonOfItsCard) {
  OverlayDriver driver;
  driver.report.selected = SelectionReport{.entities = {}};
  driver.frames();
  EXPECT_TRUE(asks<ViewSelected>(driver.click("View")));
}

}  // namespace
}  // namespace throng::app::viewer_panel_test
