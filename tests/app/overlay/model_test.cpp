// The size and place of a character, and how much a crowd differs, in the panel.
#include <gtest/gtest.h>

#include "tests/app/overlay/overlay_driver.h"

namespace throng::app::model_test {
namespace {

struct ModelSection : testing::Test {
  ModelSection() {
    driver.report.placement = {.choice = {},
                               .scale = 0.01,
                               .guessed_scale = 0.01,
                               .units_tall = 176.0,
                               .reasons = "1.76 m tall: taken as centimetres"};
    driver.frames();
    driver.point_at(1100, 600);
    driver.frames();
    driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = -100});
    driver.frames();
  }

  OverlayDriver driver;
};

TEST_F(ModelSection, AsksForASizeOnceItIsLetGo) {
  driver.point_at("Height", 0.5F);
  driver.button(true);
  driver.point_at("Height", 0.9F);
  EXPECT_FALSE(driver.frames().placement) << "it is loaded anew, which takes time";
  driver.button(false);
  const auto asked = driver.frames().placement;
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->character, 0U);
  ASSERT_TRUE(asked->choice.scale);
  EXPECT_GT(*asked->choice.scale, 0.01);
}

TEST_F(ModelSection, AsksForAnAxisAndAGround) {
  auto asked = driver.click("Up axis:z").placement;
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->choice, (anim::PlacementChoice{.up = anim::UpAxis::z}));
  driver.report.placement.choice = asked->choice;
  asked = driver.click("Ground:feet").placement;
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->choice, (anim::PlacementChoice{.up = anim::UpAxis::z, .ground = anim::GroundRule::feet}));
  EXPECT_FALSE(driver.frames(5).placement) << "once";
}

TEST_F(ModelSection, GoesBackToTheGuess) {
  driver.report.placement.choice.scale = driver.report.placement.scale = 0.5;
  driver.frames();
  const auto asked = driver.click("Scale.reset").placement;
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->choice, anim::PlacementChoice{});
}

TEST_F(ModelSection, HasNoHeightWithoutExtent) {
  EXPECT_TRUE(driver.sees("Height"));
  driver.report.placement.units_tall = 0.0;
  driver.frames();
  EXPECT_FALSE(driver.sees("Height"));
}

TEST(VarietyRows, SayHowMuchAgentsDiffer) {
  OverlayDriver driver;
  driver.drag("Tint", 0.0F);
  EXPECT_EQ(driver.tuning.tint, 0.0F);
  driver.drag("Size variety", 1.0F);
  EXPECT_EQ(driver.tuning.size_variety, 0.3F);
  driver.click("Variety");
  driver.drag("Tint", 1.0F);
  EXPECT_EQ(driver.tuning.tint, 0.0F) << "without variety nobody differs";
}

}  // namespace
}  // namespace throng::app::model_test
