// The cast in the Crowd tab.

#include <gtest/gtest.h>

#include "tests/app/overlay/overlay_driver.h"

namespace throng::app::cast_rows_test {
namespace {

TEST(CastRows, ShowAndChangeTheShareOfEachCharacter) {
  OverlayDriver driver;
  EXPECT_FALSE(driver.sees("person.glb.label")) << "one character has no share";
  driver.report.characters = {"models/person.glb", "models/knight.glb", "other/knight.glb"};
  driver.report.cast = {{.share = 3, .agents = 300}, {.share = 2, .agents = 200}, {.share = 1, .agents = 100}};
  driver.frames();
  EXPECT_TRUE(driver.sees("person.glb.label"));
  EXPECT_TRUE(driver.sees("2 knight.glb.label")) << "names that two have are told apart";
  EXPECT_TRUE(driver.sees("3 knight.glb.label"));
  const OverlayCommands dragged = driver.click("2 knight.glb");  // the middle of 0.01 to 100 is 1
  ASSERT_TRUE(dragged.share);
  EXPECT_EQ(dragged.share->character, 1U);
  EXPECT_NEAR(dragged.share->share, 1.0, 0.1);
}

TEST(CastRows, GiveAllPlacesToTheModelThatIsShown) {
  OverlayDriver driver;
  driver.report.characters = {"person.glb", "knight.glb"};
  driver.report.cast.resize(2);
  driver.report.character = 1;
  driver.frames();
  EXPECT_EQ(driver.click("Everyone is this").everyone, 1U);
}

TEST(CastRows, GoBackToTheShareThatTheCastWasLoadedWith) {
  OverlayDriver driver;
  driver.report.characters = {"person.glb", "knight.glb"};
  driver.report.cast = {{.share = 3, .starting_share = 3}, {.share = 5, .starting_share = 2}};
  driver.frames();
  EXPECT_FALSE(driver.sees("person.glb.reset"));
  const OverlayCommands reset = driver.click("knight.glb.reset");
  ASSERT_TRUE(reset.share);
  EXPECT_EQ(reset.share->share, 2.0);
}

}  // namespace
}  // namespace throng::app::cast_rows_test
