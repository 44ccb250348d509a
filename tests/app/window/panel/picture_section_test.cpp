// Pictures and videos as files, asked for in the section Picture or by keys.
#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::picture_section_test {
namespace {

void scroll_to_the_picture(OverlayDriver& driver) {
  driver.point_at("Agents", 0.5F);
  driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = -2});
  driver.frames();
}

TEST(FilesFromThePanel, HaveAButtonForAFullPictureAndAButtonAndAKeyForAVideo) {
  OverlayDriver driver;
  scroll_to_the_picture(driver);
  EXPECT_TRUE(asks<TakeStill>(driver.click("Full picture")));
  EXPECT_TRUE(asks<MakeVideo>(driver.click("Make video")));
  EXPECT_TRUE(asks<MakeVideo>(driver.press(Key::v)));
}

TEST(FilesFromThePanel, ShiftAndF12AskForTheFullPictureAndNoOtherModifierDoes) {
  OverlayDriver driver;
  driver.hold(Key::shift);
  const Requests shifted = driver.press(Key::f12);
  EXPECT_TRUE(asks<TakeStill>(shifted));
  EXPECT_FALSE(asks<TakeScreenshot>(shifted));
  for (const Key other : {Key::control, Key::alt, Key::super}) {
    driver.hold(other);
    EXPECT_FALSE(asks<TakeStill>(driver.press(Key::f12)));
    driver.let_go(other);
  }
}

TEST(FilesFromThePanel, SizeOfAFullPictureAndLengthOfAVideoAreSet) {
  OverlayDriver driver;
  scroll_to_the_picture(driver);
  driver.click("Picture times.field");
  driver.type("3");
  EXPECT_EQ(asked<SetOutput>(driver.press(Key::enter)).choices.picture_times, 3);
  driver.click("Video length.field");
  driver.type("2.5");
  EXPECT_NEAR(asked<SetOutput>(driver.press(Key::enter)).choices.video_seconds, 2.5, 0.6);
}

TEST(FilesFromThePanel, OneVideoIsMadeAtATime) {
  OverlayDriver driver;
  driver.report.jobs = {{.job = SideJob::video, .words = "throng-1.mp4: frame 9 of 60", .share = 0.15}};
  scroll_to_the_picture(driver);
  EXPECT_FALSE(asks<MakeVideo>(driver.click("Make video")));
  ASSERT_NE(driver.why_idle("Make video"), nullptr);
}

}  // namespace
}  // namespace throng::app::picture_section_test
