// The list of the parts of the body in the Crowd tab.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/character/rig_table.h"
#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::body_list_test {
namespace {

using Part = anim::BodyRole;

struct BodyList : testing::Test {
  BodyList() {
    BodyParts& body = driver.report.body;
    body.bones = {"#12", "ankle", "pelvis"};
    body.guessed[anim::index_of(Part::hips)] = "pelvis";
    body.follows = "Feet are not placed.";
    scroll_down();
  }

  void scroll_down() {
    driver.point_at(1100, 300);
    driver.frames();
    driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = -100});
    driver.frames();
  }
  void open() {
    driver.click("Show parts");
    scroll_down();
  }
  Requests choose(const std::string& part, const std::string& bone) {
    driver.click(part);
    return driver.click(part + ":" + bone);
  }

  OverlayDriver driver;
};

TEST_F(BodyList, IsClosedUntilAPersonAsksForIt) {
  EXPECT_FALSE(driver.sees("Right toes"));
  EXPECT_FALSE(driver.sees("Save body"));
  open();
  EXPECT_TRUE(driver.sees("Right toes"));
  EXPECT_TRUE(driver.sees("Save body"));
}

TEST_F(BodyList, OffersEveryBoneAndAGuess) {
  open();
  driver.click("Right foot");
  for (const std::string bone : {"guessed: none", "#12", "ankle", "pelvis"}) {
    EXPECT_TRUE(driver.sees("Right foot:" + bone)) << bone;
  }
}

TEST_F(BodyList, ClosesTheBonesByEscapeAndChoosesNone) {
  open();
  driver.click("Right foot");
  ASSERT_TRUE(driver.sees("Right foot:ankle"));
  const Requests requests = driver.press(Key::escape);
  EXPECT_FALSE(asks<Quit>(requests) || asks<SetBody>(requests));
  EXPECT_FALSE(driver.sees("Right foot:ankle"));
  EXPECT_TRUE(asks<Quit>(driver.press(Key::escape))) << "with nothing open";
}

TEST_F(BodyList, OpensTheBonesOfALowRowUpwardsSoThatAllCanBeReached) {
  for (int bone = 0; bone < 40; ++bone) driver.report.body.bones.push_back("z" + std::to_string(bone));
  open();
  driver.click("Right toes");
  const UiRectangle row = *driver.find("Right toes");
  const UiRectangle* const bone = driver.find("Right toes:ankle");
  ASSERT_NE(bone, nullptr);
  EXPECT_LT(bone->y + bone->height, row.y + 1);
}

TEST_F(BodyList, AsksForTheChosenBoneBesideWhatWasSaidBefore) {
  driver.report.body.chosen = {{Part::right_toes, "#12"}};
  driver.report.characters = {"a.glb", "b.glb"};
  driver.report.character = 1;
  scroll_down();
  open();
  const auto chosen = asked<SetBody>(choose("Right foot", "ankle"));
  EXPECT_EQ(chosen.character, 1U);
  EXPECT_EQ(chosen.parts, (std::vector<RigChoice>{{Part::right_foot, "ankle"}, {Part::right_toes, "#12"}}));
}

TEST_F(BodyList, GoesBackToTheGuessOfOnePartOrOfAll) {
  driver.report.body.chosen = {{Part::right_foot, "ankle"}, {Part::right_toes, "#12"}};
  open();
  const auto guessed = asked<SetBody>(choose("Right toes", "guessed: none"));
  EXPECT_EQ(guessed.parts, (std::vector<RigChoice>{{Part::right_foot, "ankle"}}));
  const Requests all = driver.click("Reset body");
  EXPECT_TRUE(asked<SetBody>(all).parts.empty());
  EXPECT_FALSE(asks<SaveBody>(all));
  EXPECT_TRUE(asks<SaveBody>(driver.click("Save body")));
}

TEST_F(BodyList, HasNothingToTakeBackBeforeAPersonSaysSomething) {
  open();
  EXPECT_FALSE(asks<SetBody>(driver.click("Reset body")));
}

TEST_F(BodyList, ShowsARefusalBesideThePartThatItIsAbout) {
  open();
  EXPECT_FALSE(driver.sees("Right foot.refusal"));
  driver.report.body.refused = Part::right_foot;
  driver.report.body.refusal = "pelvis cannot be the right foot: it is above ankle, the right lower leg";
  driver.frames();
  scroll_down();
  EXPECT_TRUE(driver.sees("Right foot.refusal"));
  EXPECT_FALSE(driver.sees("Right toes.refusal"));
}

}  // namespace
}  // namespace throng::app::body_list_test
