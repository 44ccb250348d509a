// The size and place of a character, and how much a crowd differs, in the panel.
#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

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
  EXPECT_FALSE(asks<SetPlacement>(driver.frames())) << "it is loaded anew, which takes time";
  driver.button(false);
  const auto placed = asked<SetPlacement>(driver.frames());
  EXPECT_EQ(placed.character, 0U);
  ASSERT_TRUE(placed.choice.scale);
  EXPECT_GT(*placed.choice.scale, 0.01);
}

TEST_F(ModelSection, AsksForAnAxisAndAGround) {
  auto placed = asked<SetPlacement>(driver.click("Up axis:z"));
  EXPECT_EQ(placed.choice, (anim::PlacementChoice{.up = anim::UpAxis::z}));
  driver.report.placement.choice = placed.choice;
  placed = asked<SetPlacement>(driver.click("Ground:feet"));
  EXPECT_EQ(placed.choice, (anim::PlacementChoice{.up = anim::UpAxis::z, .ground = anim::GroundRule::feet}));
  EXPECT_FALSE(asks<SetPlacement>(driver.frames(5))) << "once";
}

TEST_F(ModelSection, GoesBackToTheGuess) {
  driver.report.placement.choice.scale = driver.report.placement.scale = 0.5;
  driver.frames();
  EXPECT_EQ(asked<SetPlacement>(driver.click("Scale.reset")).choice, anim::PlacementChoice{});
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
  EXPECT_EQ(driver.tuning.tint, 0.0F) << "without variety no agent differs";
}

}  // namespace
}  // namespace throng::app::model_test
