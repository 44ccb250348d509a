#include <string>

#include <gtest/gtest.h>

#include "app/show/camera/scenes.h"
#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::camera_section_test {
namespace {

/// A person who looks at the section with the cameras.
class CameraSection : public testing::Test {
 protected:
  CameraSection() {
    person_.point_at(1100, 400);
    person_.frames();
    person_.input.push({.kind = InputEvent::Kind::wheel, .wheel = -5});
    person_.frames();
  }
  Requests click(const std::string& widget) { return person_.click(widget); }
  Requests press(Key key) { return person_.press(key); }

  OverlayDriver person_;
};

TEST_F(CameraSection, GoesHomeAndToEachCameraOfTheScene) {
  const auto names = scene_camera_names(person_.tuning.scene);
  ASSERT_GT(names.size(), 4U);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(asked<GoToCamera>(click(names[i])).camera, i) << names[i];
  }
  EXPECT_TRUE(asks<GoHome>(click("Home")));
  EXPECT_TRUE(asks<GoHome>(press(Key::home)));
  EXPECT_TRUE(asks<FrameCrowd>(click("Frame crowd")));
}

TEST_F(CameraSection, FollowsASelectedAgentOnly) {
  EXPECT_FALSE(asks<ToggleFollow>(click("Follow")));
  EXPECT_FALSE(asks<ToggleFollow>(press(Key::g)));
  person_.report.selected.emplace();
  person_.frames();
  EXPECT_TRUE(asks<ToggleFollow>(click("Follow")));
  EXPECT_TRUE(asks<ToggleFollow>(press(Key::g)));
  person_.report.cameras.follows = true;
  person_.frames();
  EXPECT_TRUE(asks<ToggleFollow>(click("Stop following")));
}

TEST_F(CameraSection, KeepsAPlaceAtTheFirstClickAndGoesThereAtTheNext) {
  EXPECT_EQ(asked<KeepBookmark>(click("Bookmark 3")).place, 2U);
  person_.report.cameras.kept[2] = true;
  const Requests again = click("Bookmark 3");
  EXPECT_EQ(asked<GoToBookmark>(again).place, 2U);
  EXPECT_FALSE(asks<KeepBookmark>(again));
  person_.hold(Key::control);
  EXPECT_EQ(asked<KeepBookmark>(click("Bookmark 3")).place, 2U);
}

TEST_F(CameraSection, HasKeysForBookmarks) {
  EXPECT_EQ(asked<GoToBookmark>(press(Key::digit_1)).place, 0U);
  EXPECT_EQ(asked<GoToBookmark>(press(Key::digit_9)).place, 8U);
  person_.hold(Key::control);
  const Requests kept = press(Key::digit_4);
  EXPECT_EQ(asked<KeepBookmark>(kept).place, 3U);
  EXPECT_FALSE(asks<GoToBookmark>(kept));
}

TEST_F(CameraSection, SetsTheFlyingSpeed) {
  person_.click("Flying speed.field");
  person_.type("25");
  EXPECT_EQ(asked<SetFlySpeed>(press(Key::enter)).speed, 25.0F);
}

TEST_F(CameraSection, LeavesADragWithAltToTheCamera) {
  person_.hold(Key::alt);
  person_.point_at(300, 300);
  person_.frames();
  person_.input.push({.kind = InputEvent::Kind::button, .down = true});
  person_.input.push({.kind = InputEvent::Kind::button, .down = false});
  EXPECT_FALSE(asks<SelectAt>(person_.frames())) << "it turns the camera and selects no agent";
}

}  // namespace
}  // namespace throng::app::camera_section_test
