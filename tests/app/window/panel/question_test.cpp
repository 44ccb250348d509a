// What becomes of unsaved work is asked on a card.
#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::question_test {
namespace {

struct Question : testing::Test {
  Question() {
    driver.report.unsaved = UnsavedReport{.parts = {"the values", "its camera"}, .next = "other.throng"};
    driver.frames();
  }
  OverlayDriver driver;
};

TEST_F(Question, IsAnsweredByButtons) {
  EXPECT_TRUE(asks<LeaveUnsaved>(driver.click("unsaved:leave")));
  EXPECT_TRUE(asks<KeepWorking>(driver.click("unsaved:stay")));
  driver.report.crowd = "mine";
  EXPECT_EQ(asked<SaveCrowd>(driver.click("unsaved:save")).crowd, "mine");
}

TEST_F(Question, IsAnsweredByKeys) {
  EXPECT_TRUE(asks<LeaveUnsaved>(driver.press(Key::l)));
  const Requests stays = driver.press(Key::escape);
  EXPECT_TRUE(asks<KeepWorking>(stays));
  EXPECT_FALSE(asks<Quit>(stays)) << "the key means nothing else";
  driver.report.crowd = "mine";
  EXPECT_TRUE(asks<SaveCrowd>(driver.press(Key::s)));
  EXPECT_TRUE(asks<SaveCrowd>(driver.press(Key::enter)));
}

TEST_F(Question, AsksForANameWhereTheCrowdHasNone) {
  driver.press(Key::s);
  EXPECT_TRUE(driver.sees("picker:field"));
  driver.press(Key::escape);
  EXPECT_TRUE(driver.sees("unsaved:leave")) << "it is still to be answered";
}

TEST_F(Question, IsSeenThoughThePanelIsHidden) {
  driver.overlay.set_hidden(true);
  driver.frames();
  EXPECT_TRUE(driver.sees("unsaved:save"));
}

}  // namespace
}  // namespace throng::app::question_test
