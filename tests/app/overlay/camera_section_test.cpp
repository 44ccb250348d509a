#include <string>

#include <gtest/gtest.h>

#include "app/view/scenes.h"
#include "tests/app/overlay/overlay_driver.h"

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
  CameraCommands click(const std::string& widget) { return person_.click(widget).cameras; }
  CameraCommands press(Key key) { return person_.press(key).cameras; }

  OverlayDriver person_;
};

TEST_F(CameraSection, GoesHomeAndToEachCameraOfTheScene) {
  const auto names = scene_camera_names(person_.tuning.scene);
  ASSERT_GT(names.size(), 4U);
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(click(names[i]).named, i) << names[i];
  EXPECT_TRUE(click("Home").home);
  EXPECT_TRUE(press(Key::home).home);
  EXPECT_TRUE(person_.click("Frame crowd").frame_crowd);
}

TEST_F(CameraSection, FollowsWhoIsSelectedAndNobodyElse) {
  EXPECT_FALSE(click("Follow").change_follow);
  EXPECT_FALSE(press(Key::g).change_follow);
  person_.report.selected.emplace();
  person_.frames();
  EXPECT_TRUE(click("Follow").change_follow);
  EXPECT_TRUE(press(Key::g).change_follow);
  person_.report.cameras.follows = true;
  person_.frames();
  EXPECT_TRUE(click("Stop following").change_follow);
}

TEST_F(CameraSection, KeepsAPlaceAtTheFirstClickAndGoesThereAtTheNext) {
  EXPECT_EQ(click("Bookmark 3").keep_bookmark, 2U);
  person_.report.cameras.kept[2] = true;
  const CameraCommands again = click("Bookmark 3");
  EXPECT_EQ(again.go_to_bookmark, 2U);
  EXPECT_FALSE(again.keep_bookmark);
  person_.hold(Key::control);
  EXPECT_EQ(click("Bookmark 3").keep_bookmark, 2U);
}

TEST_F(CameraSection, HasKeysForBookmarks) {
  EXPECT_EQ(press(Key::digit_1).go_to_bookmark, 0U);
  EXPECT_EQ(press(Key::digit_9).go_to_bookmark, 8U);
  person_.hold(Key::control);
  const CameraCommands kept = press(Key::digit_4);
  EXPECT_EQ(kept.keep_bookmark, 3U);
  EXPECT_FALSE(kept.go_to_bookmark);
}

TEST_F(CameraSection, SetsTheFlyingSpeed) {
  person_.click("Flying speed.field");
  person_.type("25");
  EXPECT_EQ(press(Key::enter).fly_speed, 25.0F);
}

TEST_F(CameraSection, LeavesADragWithAltToTheCamera) {
  person_.hold(Key::alt);
  person_.point_at(300, 300);
  person_.frames();
  person_.input.push({.kind = InputEvent::Kind::button, .down = true});
  person_.input.push({.kind = InputEvent::Kind::button, .down = false});
  EXPECT_FALSE(person_.frames().select_at) << "it turns the camera and selects nobody";
}

}  // namespace
}  // namespace throng::app::camera_section_test
