// How large the panel is beside the crowd.
#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::panel_size_test {
namespace {

struct PanelSize : testing::Test {
  void press_control(Key key) {
    driver.hold(Key::control);
    driver.press(key);
    driver.let_go(Key::control);
    driver.overlay.set_scale(1);
    driver.frames();
  }
  float crowd_width() const { return driver.overlay.crowd_area().width; }
  void drag_edge(float to) {
    driver.point_at("panel edge", 0.5F);
    driver.button(true);
    driver.frames();
    driver.point_at(to, 300);
    driver.frames();
    driver.button(false);
    driver.frames(30);
  }

  OverlayDriver driver;
};

TEST_F(PanelSize, LeavesTwoThirdsOfASmallWindowToThePicture) {
  EXPECT_GE(1 - column_share(800, 1), 2.0F / 3.0F);
  EXPECT_FLOAT_EQ(column_share(1280, 1), 380.0F / 1280);
}

TEST_F(PanelSize, GrowsAndShrinksByKeysWithinBounds) {
  const float usual = crowd_width();
  press_control(Key::minus);
  EXPECT_GT(crowd_width(), usual);
  press_control(Key::digit_0);
  EXPECT_EQ(crowd_width(), usual);
  for (int i = 0; i < 30; ++i) press_control(Key::plus);
  EXPECT_GE(crowd_width(), 0.4F * OverlayDriver::width);
  press_control(Key::digit_0);
  EXPECT_EQ(crowd_width(), usual);
}

TEST_F(PanelSize, IsDraggedAtItsEdgeAndADoubleClickTakesThatBack) {
  const float usual = crowd_width();
  drag_edge(700);
  EXPECT_NEAR(crowd_width(), 700, 1);
  drag_edge(10);
  EXPECT_NEAR(crowd_width(), 0.4F * OverlayDriver::width, 1) << "the crowd keeps a part";
  driver.double_click("panel edge");
  EXPECT_EQ(crowd_width(), usual);
}

TEST_F(PanelSize, IsTakenFromALastTimeAndToldForTheNext) {
  driver.overlay.set_panel_width(500);
  driver.frames();
  EXPECT_EQ(crowd_width(), OverlayDriver::width - 500);
  EXPECT_EQ(driver.overlay.panel_width(), 500);
  drag_edge(700);
  EXPECT_NEAR(driver.overlay.panel_width(), OverlayDriver::width - 700, 1);
  driver.double_click("panel edge");
  EXPECT_EQ(driver.overlay.panel_width(), 0) << "it is as usual";
}

TEST_F(PanelSize, LeavesRoomForEveryControlWhereItIsNarrow) {
  constexpr float narrow = 266;
  driver.frames();
  const float usual_track = driver.find("Agents")->width;
  driver.overlay.set_panel_width(narrow);
  driver.frames();
  EXPECT_GT(driver.find("Agents")->width, usual_track) << "a track lies below its label";
  EXPECT_GT(driver.find("Agents")->y, driver.find("Agents.field")->y);
  const UiRectangle plaza = *driver.find("Scene:plaza"), parade = *driver.find("Scene:parade");
  EXPECT_GT(plaza.width, 45) << "the word and a margin";
  EXPECT_FLOAT_EQ(plaza.y, parade.y);
  EXPECT_GT(plaza.y, driver.find("Scene.label")->y + 20) << "words that have no room beside their label lie below it";
  EXPECT_LE(driver.find("Clothes:own")->y, driver.find("Clothes.label")->y + 2) << "two short words have room";
  const UiRectangle skipping = *driver.find("tab:LOD skipping"), bones = *driver.find("tab:Per-bone LOD");
  EXPECT_GT(skipping.width, 78);
  EXPECT_GT(bones.width, 82);
}

TEST_F(PanelSize, LeavesKeysOutOfItsHeaderWhereItIsNarrow) {
  driver.frames();
  const float usual = driver.find("header:Messages (L)")->width;
  driver.overlay.set_panel_width(266);
  driver.frames();
  EXPECT_LT(driver.find("header:Messages (L)")->width, usual);
  driver.click("header:Messages (L)");
  EXPECT_TRUE(driver.sees("Messages"));
}

TEST_F(PanelSize, FollowsTheDisplay) {
  const float usual = crowd_width();
  EXPECT_FALSE(driver.overlay.set_scale(1)) << "it has that scale";
  EXPECT_TRUE(driver.overlay.set_scale(1.25F));
  driver.frames();
  EXPECT_LT(crowd_width(), usual);
}

TEST_F(PanelSize, LeavesTheWindowToF11AndAltEnter) {
  EXPECT_TRUE(asks<ToggleFullScreen>(driver.press(Key::f11)));
  EXPECT_FALSE(asks<ToggleFullScreen>(driver.press(Key::enter)));
  driver.hold(Key::alt);
  EXPECT_TRUE(asks<ToggleFullScreen>(driver.press(Key::enter)));
}

}  // namespace
}  // namespace throng::app::panel_size_test
