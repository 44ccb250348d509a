// The section Wardrobe of the tab Crowd.

#include <gtest/gtest.h>

#include "tests/app/overlay/overlay_driver.h"

namespace throng::app::wardrobe_section_test {
namespace {

struct WardrobeSection : testing::Test {
  WardrobeSection() {
    driver.tuning.wardrobe = true;
    driver.frames();
  }
  OverlayDriver driver;
};

TEST_F(WardrobeSection, ChangesTheShareOfABodyWhereTheTrackIsLetGo) {
  driver.point_at("Man", 0.75F);
  driver.button(true);
  EXPECT_FALSE(driver.frames().wardrobe.cast) << "dressing takes time, so it waits";
  driver.button(false);
  const OverlayCommands commands = driver.frames();
  ASSERT_TRUE(commands.wardrobe.cast);
  EXPECT_NEAR(commands.wardrobe.cast->tuning.bodies[0].weight, 75.0F, 4.0F);
  EXPECT_EQ(commands.wardrobe.cast->tuning.bodies[1].weight, 46.0F);
  EXPECT_EQ(commands.wardrobe.cast->tuning.seed, 0U);
}

TEST_F(WardrobeSection, ChangesHowManyHoldThings) {
  const OverlayCommands commands = driver.click("Things in hands");
  ASSERT_TRUE(commands.wardrobe.cast);
  EXPECT_NEAR(commands.wardrobe.cast->tuning.things, 5.0F, 0.5F);
}

TEST_F(WardrobeSection, ShowsStylesWhenTheyAreAskedFor) {
  EXPECT_FALSE(driver.sees("Style casual"));
  driver.click("Show styles");
  EXPECT_TRUE(driver.sees("Style office"));
  const OverlayCommands commands = driver.click("Style casual");
  ASSERT_TRUE(commands.wardrobe.cast);
  EXPECT_NEAR(commands.wardrobe.cast->tuning.styles[0].weight, 50.0F, 2.0F);
  EXPECT_EQ(commands.wardrobe.cast->tuning.styles[1].weight, 3.0F);
  driver.click("Hide styles");
  EXPECT_FALSE(driver.sees("Style casual"));
}

TEST_F(WardrobeSection, DressesEverybodyAnewFromAnotherSeed) {
  const OverlayCommands commands = driver.click("Dress anew");
  ASSERT_TRUE(commands.wardrobe.cast);
  EXPECT_EQ(commands.wardrobe.cast->tuning.seed, 1U);
  EXPECT_EQ(commands.wardrobe.cast->tuning.bodies, driver.report.wardrobe.tuning.bodies);
}

TEST_F(WardrobeSection, GoesBackToWhatTheFileSays) {
  EXPECT_FALSE(driver.click("Reset rules").wardrobe.cast);
  driver.report.wardrobe.tuning.bodies[2].weight = 80.0F;
  driver.report.wardrobe.tuning.seed = 4;
  driver.frames();
  const OverlayCommands one = driver.click("Child.reset");
  ASSERT_TRUE(one.wardrobe.cast);
  EXPECT_EQ(one.wardrobe.cast->tuning.bodies[2].weight, 10.0F);
  EXPECT_EQ(one.wardrobe.cast->tuning.seed, 4U);
  const OverlayCommands all = driver.click("Reset rules");
  ASSERT_TRUE(all.wardrobe.cast);
  EXPECT_EQ(all.wardrobe.cast->tuning, driver.report.wardrobe.standard);
}

TEST_F(WardrobeSection, SavesRulesUnderANameAndReadsThemOrTheFileInForceAgain) {
  EXPECT_FALSE(driver.click("Save rules").wardrobe.save) << "it has no name";
  EXPECT_EQ(driver.click("Load rules").wardrobe.load, "");
  driver.click("Rules.field");
  driver.type("mine");
  EXPECT_EQ(driver.click("Save rules").wardrobe.save, "mine");
  EXPECT_EQ(driver.click("Load rules").wardrobe.load, "mine");
}

TEST_F(WardrobeSection, SaysWhyNothingCanBeReadWhereRulesAreOfNoFile) {
  driver.report.wardrobe.file.clear();
  driver.frames();
  EXPECT_FALSE(driver.click("Load rules").wardrobe.load);
}

TEST_F(WardrobeSection, DoesNothingWhileTheWardrobeIsOff) {
  driver.tuning.wardrobe = false;
  driver.frames();
  EXPECT_FALSE(driver.click("Man").wardrobe.cast);
  EXPECT_FALSE(driver.click("Dress anew").wardrobe.cast);
}

TEST_F(WardrobeSection, OfACharacterWithoutRulesHasTheTwoValuesAlone) {
  driver.report.wardrobe = {};
  driver.frames();
  EXPECT_TRUE(driver.sees("Weather.label"));
  EXPECT_FALSE(driver.sees("Man"));
  EXPECT_FALSE(driver.sees("Dress anew"));
}

}  // namespace
}  // namespace throng::app::wardrobe_section_test
