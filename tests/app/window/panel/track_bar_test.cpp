// The timeline of a recorded crowd at the foot of the crowd.
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::track_bar_test {
namespace {

/// A file of a hundred seconds, with ten people in its middle.
TracksReport some_tracks(double first = 0.0, double last = 100.0) {
  Trajectories all;
  for (int person = 0; person < 10; ++person) {
    all.persons.push_back({.id = std::to_string(person), .rows = {{.seconds = 40.0}, {.seconds = 60.0}}});
  }
  all.persons.push_back({.id = "all", .rows = {{.seconds = first}, {.seconds = last}}});
  all.first_seconds = first;
  all.last_seconds = last;
  all.rows_a_second = 10.0;
  return {.clock = {.seconds = first, .first = first, .last = last, .repeats = true},
          .people = std::make_shared<const PeopleOverTime>(all)};
}

class TrackBar : public testing::Test {
 protected:
  TrackBar() {
    person_.report.tracks = some_tracks();
    person_.frames();
  }
  const TrackClock& clock() const { return person_.report.tracks->clock; }
  void put(double seconds) { person_.report.tracks->clock.seconds = seconds; }
  void press_with_shift(Key key) {
    person_.hold(Key::shift);
    person_.press(key);
    person_.let_go(Key::shift);
    person_.frames();
  }

  OverlayDriver person_;
};

TEST_F(TrackBar, IsThereOnlyWithARecordedCrowd) {
  EXPECT_TRUE(person_.sees("Tracks"));
  EXPECT_TRUE(person_.sees("Tracks.track"));
  person_.report.tracks.reset();
  person_.frames();
  EXPECT_FALSE(person_.sees("Tracks"));
  EXPECT_FALSE(asks<Seek>(person_.press(Key::left)));
}

TEST_F(TrackBar, IsNoPartOfThePictureThatCamerasUse) {
  const UiRectangle crowd = person_.overlay.crowd_area(), free = person_.overlay.free_area(person_.report);
  const UiRectangle bar = *person_.find("Tracks");
  EXPECT_LE(free.y + free.height, bar.y);
  EXPECT_EQ(free.width, crowd.width);
  person_.overlay.set_hidden(true);
  EXPECT_EQ(person_.overlay.free_area(person_.report).height, OverlayDriver::height);
  person_.overlay.set_hidden(false);
  person_.report.tracks.reset();
  EXPECT_EQ(person_.overlay.free_area(person_.report).height, crowd.height);
}

TEST_F(TrackBar, GoesToTheTimeThatIsPressedAndAlongWithADrag) {
  person_.click("Tracks.track");
  EXPECT_NEAR(clock().seconds, 50.0, 0.2);
  person_.drag("Tracks.track", 0.25F);
  EXPECT_NEAR(clock().seconds, 25.0, 0.2);
  EXPECT_FALSE(person_.tuning.paused) << "it goes on from there";
}

TEST_F(TrackBar, StaysWhereThePointerHoldsItWhileItPlays) {
  person_.point_at("Tracks.track", 0.5F);
  person_.button(true);
  person_.frames();
  put(50.4);
  person_.frames(1);
  EXPECT_NEAR(clock().seconds, 50.0, 0.2);
  person_.button(false);
  person_.frames();
}

TEST_F(TrackBar, PlaysBothWaysAndPauses) {
  person_.click("Tracks.play");
  EXPECT_TRUE(person_.tuning.paused);
  person_.click("Tracks.play");
  EXPECT_FALSE(person_.tuning.paused);
  person_.click("Tracks.backwards");
  EXPECT_EQ(clock().rate, -1.0);
  EXPECT_FALSE(person_.tuning.paused);
  person_.click("Tracks.backwards");
  EXPECT_TRUE(person_.tuning.paused);
  person_.click("Tracks.play");
  EXPECT_EQ(clock().rate, 1.0);
  press_with_shift(Key::space);
  EXPECT_EQ(clock().rate, -1.0);
  EXPECT_FALSE(person_.tuning.paused);
  person_.press(Key::space);
  EXPECT_TRUE(person_.tuning.paused);
}

TEST_F(TrackBar, PlaysFromTheBeginningOnceItHasEnded) {
  person_.click("Tracks.loop");
  EXPECT_FALSE(clock().repeats);
  put(100.0);
  person_.click("Tracks.play");
  EXPECT_EQ(clock().seconds, 0.0);
  EXPECT_FALSE(person_.tuning.paused);
  put(100.0);
  person_.press(Key::space);
  EXPECT_EQ(clock().seconds, 0.0);
  EXPECT_FALSE(person_.tuning.paused);
}

TEST_F(TrackBar, StepsByRowsAndSeconds) {
  put(50.0);
  person_.click("Tracks.on");
  EXPECT_NEAR(clock().seconds, 50.1, 1e-6);
  EXPECT_TRUE(person_.tuning.paused);
  person_.click("Tracks.back");
  EXPECT_NEAR(clock().seconds, 50.0, 1e-6);
  person_.press(Key::right);
  EXPECT_NEAR(clock().seconds, 50.1, 1e-6);
  person_.press(Key::left);
  EXPECT_NEAR(clock().seconds, 50.0, 1e-6);
  press_with_shift(Key::right);
  EXPECT_NEAR(clock().seconds, 51.0, 1e-6);
  press_with_shift(Key::left);
  EXPECT_NEAR(clock().seconds, 50.0, 1e-6);
}

TEST_F(TrackBar, HasRatesFromATenthToEightTimesInBothDirections) {
  for (int i = 0; i < 9; ++i) person_.click("Tracks.faster");
  EXPECT_EQ(clock().rate, 8.0);
  for (int i = 0; i < 9; ++i) person_.click("Tracks.slower");
  EXPECT_EQ(clock().rate, 0.1);
  person_.click("Tracks.backwards");
  person_.click("Tracks.faster");
  EXPECT_EQ(clock().rate, -0.25);
  person_.click("Tracks.rate");
  EXPECT_EQ(clock().rate, -1.0);
  person_.report.tracks->clock.rate = 3.0;
  person_.click("Tracks.faster");
  EXPECT_EQ(clock().rate, 4.0) << "the next one, from a rate of the command line";
}

TEST_F(TrackBar, PlaysAPartBetweenItsHandlesAndTheWholeAgain) {
  put(50.0);
  person_.drag_to("Tracks.from", "Tracks.track");
  EXPECT_NEAR(clock().first, 50.0, 1.0);
  person_.drag("Tracks.track", 0.75F);
  person_.drag_to("Tracks.to", "Tracks.track");
  EXPECT_NEAR(clock().last, 50.0, 1.0) << "no farther than its other end";
  EXPECT_GE(clock().last, clock().first);
  person_.click("Tracks.whole");
  EXPECT_EQ(clock().first, 0.0);
  EXPECT_EQ(clock().last, 100.0);
}

TEST_F(TrackBar, HasAButtonForAVideoOfThePart) { EXPECT_TRUE(asks<MakeVideo>(person_.click("Tracks.video"))); }

TEST_F(TrackBar, APartOfNoLengthStillHasTwoHandles) {
  put(50.0);
  person_.type("[");
  person_.type("]");
  EXPECT_EQ(clock().first, 50.0);
  EXPECT_EQ(clock().last, 50.0);
  const UiRectangle from = *person_.find("Tracks.from"), to = *person_.find("Tracks.to");
  EXPECT_LE(from.x + from.width, to.x + 0.5F);
  person_.drag("Tracks.to", 8.0F);
  EXPECT_GT(clock().last, 52.0);
}

TEST_F(TrackBar, PutsTheEndsOfThePartAtThePresentTimeByKey) {
  put(30.0);
  person_.type("[");
  put(70.0);
  person_.type("]");
  EXPECT_EQ(clock().first, 30.0);
  EXPECT_EQ(clock().last, 70.0);
  person_.click("Tracks.track");
  EXPECT_NEAR(clock().seconds, 50.0, 0.2);
  person_.drag("Tracks.track", 0.9F);
  EXPECT_EQ(clock().seconds, 70.0) << "the track goes no farther than the part";
}

TEST_F(TrackBar, OfAFileOfOneRowOrOfManyHoursHasAllItsControls) {
  for (const double last : {0.0, 60'000.0}) {
    person_.report.tracks = some_tracks(0.0, last);
    person_.frames();
    for (const std::string part : {"play", "track", "from", "to", "loop", "whole", "rate"}) {
      EXPECT_TRUE(person_.sees("Tracks." + part)) << part << " of " << last;
    }
    person_.click("Tracks.track");
    EXPECT_NEAR(clock().seconds, last / 2, last / 100);
    person_.press(Key::right);
    person_.click("Tracks.play");
  }
}

TEST_F(TrackBar, KeepsPlayerAndTrackInASmallWindow) {
  for (int frame = 0; frame < 3; ++frame) {
    person_.overlay.begin_frame(600, 400, 1.0 / 60, {});
    person_.overlay.build(person_.report, person_.tuning);
  }
  EXPECT_TRUE(person_.sees("Tracks.play"));
  EXPECT_TRUE(person_.sees("Tracks.track"));
}

TEST_F(TrackBar, TakesThePlaceOfSnapshots) {
  ASSERT_NE(person_.why_idle("Back by"), nullptr);
  EXPECT_EQ(*person_.why_idle("Back by"), "the timeline at the foot of the crowd goes to any moment");
}

TEST_F(TrackBar, IsInTheMapAsTheReportHasIt) {
  put(50.0);
  const auto map = nlohmann::json::parse(to_json(person_.overlay.ui_map(), person_.tuning, person_.report));
  EXPECT_EQ(map["report"]["tracks"]["seconds"], 50.0);
  EXPECT_EQ(map["report"]["tracks"]["people"], 11);
  EXPECT_EQ(map["report"]["tracks"]["last"], 100.0);
}

}  // namespace
}  // namespace throng::app::track_bar_test
