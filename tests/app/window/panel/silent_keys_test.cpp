// A key that does nothing now says why; a word that cannot be chosen does too.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::silent_keys_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::string told(const Requests& requests) {
  const Tell* const last = last_of<Tell>(requests);
  return last == nullptr ? "" : last->words;
}

TEST(KeyThatDoesNothing, SaysWhatItNeeds) {
  OverlayDriver driver;
  EXPECT_THAT(told(driver.press(Key::p)), HasSubstr("Click at one first"));
  EXPECT_THAT(told(driver.press(Key::g)), HasSubstr("Click at one first"));
  EXPECT_THAT(told(driver.press(Key::left)), HasSubstr("a replay or a recorded crowd"));
  EXPECT_THAT(told(driver.press(Key::up)), HasSubstr("F6"));
  EXPECT_THAT(told(driver.press(Key::digit_4)), HasSubstr("Ctrl+4"));
}

TEST(KeyThatDoesSomething, SaysNothing) {
  OverlayDriver driver;
  driver.report.cameras.kept.at(3) = true;
  driver.report.selected = SelectionReport{.agent = 2, .can_fall = true, .entities = {}};
  driver.report.replay.emplace();
  for (const Key key : {Key::p, Key::g, Key::left, Key::digit_4, Key::space, Key::f, Key::home, Key::x, Key::w}) {
    EXPECT_THAT(told(driver.press(key)), IsEmpty()) << static_cast<int>(key);
  }
  driver.hold(Key::control);
  EXPECT_THAT(told(driver.press(Key::digit_5)), IsEmpty()) << "it keeps a place";
}

TEST(KeyOfTheCrowd, SaysHowToLeaveTheViewer) {
  OverlayDriver driver;
  driver.report.viewer.emplace();
  EXPECT_THAT(told(driver.press(Key::p)), HasSubstr("Esc leaves the viewer"));
  EXPECT_THAT(told(driver.press(Key::f)), IsEmpty()) << "which the viewer knows";
}

TEST(SceneOfTracks, IsNoChoiceWithoutAFileOfTrajectories) {
  OverlayDriver driver;
  driver.report.situation.has_tracks = false;
  driver.frames();
  ASSERT_NE(driver.why_idle("Scene:tracks"), nullptr);
  EXPECT_THAT(*driver.why_idle("Scene:tracks"), HasSubstr("drop one on the window"));
  driver.click("Scene:tracks");
  EXPECT_EQ(driver.tuning.scene, Scene::plaza);
  driver.click("Scene:film");
  EXPECT_EQ(driver.tuning.scene, Scene::film);
  driver.press(Key::f6);
  driver.click("Scene:film");
  driver.report.situation.has_tracks = true;
  driver.frames();
  EXPECT_EQ(driver.why_idle("Scene:tracks"), nullptr);
  driver.click("Scene:tracks");
  EXPECT_EQ(driver.tuning.scene, Scene::tracks);
}

TEST(WordThatCannotBeChosen, IsPassedByTheKeyboard) {
  OverlayDriver driver;
  driver.report.situation.has_tracks = false;
  driver.tuning.scene = Scene::film;
  driver.press(Key::f6);
  for (int i = 0; i < 40 && !driver.overlay.ui_map().focus.starts_with("Scene:"); ++i) driver.press(Key::down);
  ASSERT_EQ(driver.overlay.ui_map().focus, "Scene:film");
  driver.press(Key::right);
  EXPECT_EQ(driver.tuning.scene, Scene::film) << "tracks is the last word";
  driver.press(Key::enter);
  EXPECT_EQ(driver.tuning.scene, Scene::plaza) << "once round";
}

}  // namespace
}  // namespace throng::app::silent_keys_test
