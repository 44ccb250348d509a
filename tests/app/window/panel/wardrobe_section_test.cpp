// The section Wardrobe of the tab Crowd.

#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

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
  EXPECT_FALSE(asks<TuneRules>(driver.frames())) << "dressing takes time, so it waits";
  driver.button(false);
  const auto rules = asked<TuneRules>(driver.frames());
  EXPECT_EQ(rules.character, 0U);
  ASSERT_EQ(rules.tuning.bodies.size(), 3U);
  EXPECT_NEAR(rules.tuning.bodies[0].weight, 75.0F, 4.0F);
  EXPECT_EQ(rules.tuning.bodies[1].weight, 46.0F);
  EXPECT_EQ(rules.tuning.seed, 0U);
}

TEST_F(WardrobeSection, ChangesHowManyHoldThings) {
  EXPECT_NEAR(asked<TuneRules>(driver.click("Things in hands")).tuning.things, 5.0F, 0.5F);
}

TEST_F(WardrobeSection, ShowsStylesWhenTheyAreAskedFor) {
  EXPECT_FALSE(driver.sees("Style casual"));
  driver.click("Show styles");
  EXPECT_TRUE(driver.sees("Style office"));
  const auto rules = asked<TuneRules>(driver.click("Style casual"));
  ASSERT_EQ(rules.tuning.styles.size(), 2U);
  EXPECT_NEAR(rules.tuning.styles[0].weight, 50.0F, 2.0F);
  EXPECT_EQ(rules.tuning.styles[1].weight, 3.0F);
  driver.click("Hide styles");
  EXPECT_FALSE(driver.sees("Style casual"));
}

TEST_F(WardrobeSection, DressesAllAgentsAnewFromAnotherSeed) {
  const auto rules = asked<TuneRules>(driver.click("Dress anew"));
  EXPECT_EQ(rules.tuning.seed, 1U);
  EXPECT_EQ(rules.tuning.bodies, driver.report.wardrobe.tuning.bodies);
}

TEST_F(WardrobeSection, GoesBackToWhatTheFileSays) {
  EXPECT_FALSE(asks<TuneRules>(driver.click("Reset rules")));
  driver.report.wardrobe.tuning.bodies[2].weight = 80.0F;
  driver.report.wardrobe.tuning.seed = 4;
  driver.frames();
  const auto one = asked<TuneRules>(driver.click("Child.reset"));
  ASSERT_EQ(one.tuning.bodies.size(), 3U);
  EXPECT_EQ(one.tuning.bodies[2].weight, 10.0F);
  EXPECT_EQ(one.tuning.seed, 4U);
  EXPECT_EQ(asked<TuneRules>(driver.click("Reset rules")).tuning, driver.report.wardrobe.standard);
}

TEST_F(WardrobeSection, SavesRulesUnderANameAndReadsThemOrTheFileInForceAgain) {
  EXPECT_FALSE(asks<SaveRules>(driver.click("Save rules"))) << "it has no name";
  EXPECT_EQ(asked<LoadRules>(driver.click("Load rules")).rules, "");
  driver.click("Rules.field");
  driver.type("mine");
  EXPECT_EQ(asked<SaveRules>(driver.click("Save rules")).rules, "mine");
  EXPECT_EQ(asked<LoadRules>(driver.click("Load rules")).rules, "mine");
}

TEST_F(WardrobeSection, SaysWhyNothingCanBeReadWhereRulesAreOfNoFile) {
  driver.report.wardrobe.file.clear();
  driver.frames();
  EXPECT_FALSE(asks<LoadRules>(driver.click("Load rules")));
}

TEST_F(WardrobeSection, DoesNothingWhileTheWardrobeIsOff) {
  driver.tuning.wardrobe = false;
  driver.frames();
  EXPECT_FALSE(asks<TuneRules>(driver.click("Man")));
  EXPECT_FALSE(asks<TuneRules>(driver.click("Dress anew")));
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
