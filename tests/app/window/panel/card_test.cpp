#include <string>

#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::card_test {
namespace {

float share_of_crowd(const OverlayDriver& driver, const std::string& card) {
  const UiRectangle crowd = driver.overlay.crowd_area();
  const UiRectangle* const place = driver.find(card);
  return place == nullptr ? 0 : place->width * place->height / (crowd.width * crowd.height);
}

TEST(Card, CoversAtMostAFifthOfTheCrowd) {
  OverlayDriver driver;
  for (int i = 0; i < 100; ++i) driver.report.messages.say("line " + std::to_string(i));
  driver.press(Key::l);
  EXPECT_GT(share_of_crowd(driver, "Messages"), 0);
  EXPECT_LE(share_of_crowd(driver, "Messages"), 0.2F);
}

TEST(HelpCard, ShowsAllKeysAtOnceInAWindowOfTheUsualSize) {
  OverlayDriver driver;
  driver.shown_height = 720;
  driver.press(Key::f1);
  for (const std::string key : {"W A S D", "Click", "Home", "Ctrl+Z, +Y", "[, ]", "Tab", "F12", "F1", "Esc"}) {
    ASSERT_TRUE(driver.sees("help:" + key)) << key;
    EXPECT_GE(driver.find("help:" + key)->height, 18) << key << " is cut off";
  }
  EXPECT_LE(share_of_crowd(driver, "Help"), 1.0F);
}

TEST(Card, FoldsToItsTitleAndUnfolds) {
  OverlayDriver driver;
  driver.press(Key::f1);
  const float unfolded = share_of_crowd(driver, "Help");
  driver.click("Help.fold");
  EXPECT_LT(share_of_crowd(driver, "Help"), unfolded / 4);
  driver.click("Help.fold");
  EXPECT_EQ(share_of_crowd(driver, "Help"), unfolded);
}

TEST(Card, MovesByItsTitleAndStaysInTheCrowd) {
  OverlayDriver driver;
  driver.press(Key::f1);
  const UiRectangle before = *driver.find("Help");
  driver.drag_to("Help.title", "tab:Crowd");
  const UiRectangle after = *driver.find("Help");
  EXPECT_GT(after.x, before.x);
  EXPECT_LE(after.x + after.width, driver.overlay.crowd_area().width) << "not below the panel";
  EXPECT_GE(after.y, 0);
}

TEST(HelpCard, ExplainsAWordThatIsSearched) {
  OverlayDriver driver;
  driver.press(Key::f1);
  const float all = driver.find("Help")->height;
  driver.click("Search.field");
  driver.type("tolerance");
  EXPECT_LT(driver.find("Help")->height, all) << "one line is left";
}

}  // namespace
}  // namespace throng::app::card_test
