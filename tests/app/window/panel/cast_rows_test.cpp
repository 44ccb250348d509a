// The cast in the Crowd tab.
#include <vector>

#include <gtest/gtest.h>

#include "app/character/cast_entry.h"
#include "tests/app/window/panel/overlay_driver.h"

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
  const auto dragged = asked<SetShare>(driver.click("2 knight.glb"));  // the middle of 0.01 to 100 is 1
  EXPECT_EQ(dragged.character, 1U);
  EXPECT_NEAR(dragged.share, 1.0, 0.1);
}

TEST(CastRows, GoBackToTheBuiltInPeopleFromOthers) {
  OverlayDriver driver;
  EXPECT_FALSE(driver.sees("Back to the built-in people")) << "they are shown";
  driver.report.has_built_in_cast = false;
  driver.frames();
  const auto cast = asked<SetCast>(driver.click("Back to the built-in people"));
  EXPECT_EQ(cast.characters, std::vector{ChosenCharacter{}});
}

TEST(CastRows, GiveAllPlacesToTheModelThatIsShown) {
  OverlayDriver driver;
  driver.report.characters = {"person.glb", "knight.glb", "dog.glb"};
  driver.report.cast.resize(3);
  driver.report.character = 1;
  driver.frames();
  std::vector<SetShare> shares;
  for (const Request& request : driver.click("Everyone is this")) {
    if (const auto* const share = as<SetShare>(request)) shares.push_back(*share);
  }
  ASSERT_EQ(shares.size(), 3U) << "one for each character";
  for (const SetShare& share : shares) {
    EXPECT_EQ(share.share, share.character == 1 ? most_share : least_share) << share.character;
  }
}

TEST(CastRows, GoBackToTheShareThatTheCastWasLoadedWith) {
  OverlayDriver driver;
  driver.report.characters = {"person.glb", "knight.glb"};
  driver.report.cast = {{.share = 3, .starting_share = 3}, {.share = 5, .starting_share = 2}};
  driver.frames();
  EXPECT_FALSE(driver.sees("person.glb.reset"));
  const auto reset = asked<SetShare>(driver.click("knight.glb.reset"));
  EXPECT_EQ(reset.character, 1U);
  EXPECT_EQ(reset.share, 2.0);
}

}  // namespace
}  // namespace throng::app::cast_rows_test
