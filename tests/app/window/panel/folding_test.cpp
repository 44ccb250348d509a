// The sections of the tab Crowd fold.
#include <string>

#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::folding_test {
namespace {

TEST(FoldingSection, HidesItsRowsUntilItIsClickedAgain) {
  OverlayDriver driver;
  ASSERT_TRUE(driver.sees("Agents"));
  const float below = driver.find("section:Wardrobe")->y;
  driver.click("section:Who");
  EXPECT_FALSE(driver.sees("Agents"));
  EXPECT_LT(driver.find("section:Wardrobe")->y, below);
  driver.click("section:Who");
  EXPECT_TRUE(driver.sees("Agents"));
}

TEST(FoldingSection, StaysFoldedWhileOtherTabsAreShown) {
  OverlayDriver driver;
  driver.click("section:Who");
  driver.click("tab:Scheduling");
  driver.click("tab:Crowd");
  EXPECT_FALSE(driver.sees("Agents"));
}

TEST(FoldingSection, IsFoldedByTheKeyboardToo) {
  OverlayDriver driver;
  driver.press(Key::f6);
  for (int i = 0; i < 3 && driver.overlay.ui_map().focus != "section:Who"; ++i) driver.press(Key::up);
  for (int i = 0; i < 40 && driver.overlay.ui_map().focus != "section:Who"; ++i) driver.press(Key::down);
  ASSERT_EQ(driver.overlay.ui_map().focus, "section:Who");
  driver.press(Key::enter);
  EXPECT_FALSE(driver.sees("Agents"));
}

TEST(FoldingSection, UnfoldsWhereASearchLeadsToIt) {
  OverlayDriver driver;
  driver.click("section:Who");
  driver.click("search");
  driver.type("Seed");
  driver.click("found:Crowd/Who");
  EXPECT_TRUE(driver.sees("Seed"));
}

TEST(FoldingSection, OfTheTabCrowdAreAllOfThem) {
  OverlayDriver driver;
  driver.shown_height = 4000;
  driver.frames();
  for (const std::string title :
       {"Who", "Wardrobe", "Time", "Picture", "Camera", "Light", "In this frame", "Model", "Roles", "Body"}) {
    EXPECT_TRUE(driver.sees("section:" + title)) << title;
  }
}

}  // namespace
}  // namespace throng::app::folding_test
