#include <string>

#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::notices_test {
namespace {

TEST(Notices, ARecordingIsSeenWhateverIsSaid) {
  OverlayDriver driver;
  driver.report.recording.file = "throng-1.rec";
  driver.report.messages.say("Wrote throng-1.png");
  driver.frames();
  EXPECT_TRUE(driver.sees("badge:recording"));
  EXPECT_TRUE(driver.sees("message:0"));
  driver.report.messages.pass(60);
  driver.frames();
  EXPECT_TRUE(driver.sees("badge:recording"));
  EXPECT_FALSE(driver.sees("message:0"));
  EXPECT_TRUE(asks<ToggleRecording>(driver.click("badge:recording")));
}

struct State {
  const char* badge;
  void (*begin)(Tuning& tuning);
};

constexpr State states[] = {
    {"badge:paused", [](Tuning& tuning) { tuning.paused = true; }},
    {"badge:frozen", [](Tuning& tuning) { tuning.inspection.freeze_camera = true; }},
    {"badge:split", [](Tuning& tuning) { tuning.inspection.split = Split::difference; }},
    {"badge:interval", [](Tuning& tuning) { tuning.inspection.forced_interval = 4; }},
    {"badge:level", [](Tuning& tuning) { tuning.inspection.forced_bone_level = 0; }},
    {"badge:taken_away", [](Tuning& tuning) { tuning.taken_away.drawing = true; }},
};

TEST(Notices, AStateHasItsBadgeUntilAClickEndsIt) {
  for (const State& state : states) {
    OverlayDriver driver;
    const Tuning before = driver.tuning;
    driver.frames();
    EXPECT_FALSE(driver.sees(state.badge)) << state.badge;
    state.begin(driver.tuning);
    driver.frames();
    ASSERT_TRUE(driver.sees(state.badge)) << state.badge;
    driver.click(state.badge);
    EXPECT_FALSE(driver.sees(state.badge)) << state.badge;
    EXPECT_EQ(driver.tuning, before) << state.badge;
  }
}

TEST(Notices, TheTuningInUseIsNamedOnceThereAreTwo) {
  OverlayDriver driver;
  driver.frames();
  EXPECT_FALSE(driver.sees("badge:pair"));
  driver.overlay.tuning_pair().copy_to_other(driver.tuning);
  driver.frames();
  ASSERT_TRUE(driver.sees("badge:pair"));
  EXPECT_FALSE(driver.overlay.ui_map().shows_b);
  const float unnamed = driver.find("badge:pair")->width;
  driver.overlay.tuning_pair().names[0] = "baseline";
  driver.frames();
  EXPECT_GT(driver.find("badge:pair")->width, unnamed) << "it has room for the name";
  driver.click("badge:pair");
  EXPECT_TRUE(driver.overlay.ui_map().shows_b);
}

TEST(Notices, TheExactCrowdIsNamedWhileXIsHeld) {
  OverlayDriver driver;
  driver.input.push({.kind = InputEvent::Kind::key, .key = Key::x, .down = true});
  driver.frames();
  EXPECT_TRUE(driver.sees("badge:exact"));
}

TEST(Notices, EachWarningStaysUntilItIsClosed) {
  OverlayDriver driver;
  driver.report.notice = "one\ntwo";
  driver.report.messages.pass(600);
  driver.frames();
  EXPECT_TRUE(driver.sees("warning:1"));
  driver.click("warning:0");
  EXPECT_TRUE(driver.sees("warning:0")) << "the other one";
  EXPECT_FALSE(driver.sees("warning:1"));
  driver.click("warning:0");
  EXPECT_FALSE(driver.sees("warning:0"));
  driver.report.notice += "\nthree";
  driver.frames();
  EXPECT_TRUE(driver.sees("warning:0")) << "another warning is another thing";
}

class ManyWarnings : public testing::Test {
 protected:
  ManyWarnings() {
    driver_.report.notice = "the device";
    driver_.frames();
    for (int file = 0; file < 12; ++file) driver_.report.notice += "\nmodel " + std::to_string(file);
    driver_.frames();
  }
  OverlayDriver driver_;
};

TEST_F(ManyWarnings, ThatComeAtOnceShareALineBesideEarlierOnes) {
  EXPECT_TRUE(driver_.sees("warning:0"));
  EXPECT_FALSE(driver_.sees("warning:1"));
  EXPECT_TRUE(driver_.sees("remarks"));
  EXPECT_FALSE(driver_.sees("Remarks"));
  driver_.report.notice += "\nmemory ran out";
  driver_.frames();
  EXPECT_TRUE(driver_.sees("warning:1")) << "a later one is not hidden among them";
}

TEST_F(ManyWarnings, AreListedByAClickWithinTwoFifthsOfTheCrowd) {
  driver_.click("remarks");
  ASSERT_TRUE(driver_.sees("Remarks"));
  const UiRectangle list = *driver_.find("Remarks"), crowd = driver_.overlay.crowd_area();
  EXPECT_LE(list.width * list.height, 0.4F * crowd.width * crowd.height);
  driver_.click("remarks");
  EXPECT_FALSE(driver_.sees("Remarks"));
  driver_.click("remarks");
  driver_.click("Remarks.close");
  EXPECT_FALSE(driver_.sees("Remarks"));
  EXPECT_TRUE(driver_.sees("remarks")) << "they are only folded";
}

TEST_F(ManyWarnings, AreClosedTogether) {
  driver_.click("remarks");
  driver_.click("remarks:close");
  EXPECT_FALSE(driver_.sees("Remarks"));
  EXPECT_FALSE(driver_.sees("remarks"));
  EXPECT_TRUE(driver_.sees("warning:0")) << "the one of before is none of them";
}

TEST(Notices, AMessageThatWasClosedIsInTheLog) {
  OverlayDriver driver;
  driver.report.messages.say("Wrote throng-1.png");
  driver.frames();
  driver.click("message:0");
  EXPECT_FALSE(driver.sees("message:0"));
  EXPECT_FALSE(driver.sees("Messages"));
  driver.press(Key::l);
  EXPECT_TRUE(driver.sees("Messages"));
  driver.click("Messages.close");
  EXPECT_FALSE(driver.sees("Messages"));
}

TEST(Notices, ALongOneTakesMoreLinesAndStaysInTheCrowd) {
  OverlayDriver driver;
  driver.report.messages.say(std::string(60, 'w') + " " + std::string(60, 'w') + " " + std::string(60, 'w'));
  driver.frames();
  const UiRectangle* const place = driver.find("message:0");
  ASSERT_NE(place, nullptr);
  EXPECT_LE(place->x + place->width, driver.overlay.crowd_area().width);
  EXPECT_GT(place->height, 40) << "more than a line";
}

TEST(Notices, EscClosesTheLogAndThenAsksToLeave) {
  OverlayDriver driver;
  driver.press(Key::l);
  EXPECT_FALSE(asks<Quit>(driver.press(Key::escape)));
  EXPECT_FALSE(driver.sees("Messages"));
  EXPECT_TRUE(asks<Quit>(driver.press(Key::escape)));
}

}  // namespace
}  // namespace throng::app::notices_test
