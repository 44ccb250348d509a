#include "engine/tracks/live/live_crowd.h"

#include <chrono>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tracks/live/live_feed.h"

namespace throng::live_crowd_test {
namespace {

using Pace = LiveCrowd::Pace;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double frame = 1.0 / 60.0;
constexpr std::chrono::milliseconds soon(100);

/// A row of somebody who walks a metre a second to the right.
std::string row(const std::string& id, double seconds) {
  return id + "," + std::to_string(seconds) + "," + std::to_string(seconds) + ",0\n";
}
std::string rows(const std::string& id, double from, double to, double every = 0.1) {
  std::string text;
  for (int i = 0; from + i * every < to; ++i) text += row(id, from + i * every);
  return text;
}
const std::string header = "id,time,x,y\n";

class LiveCrowds : public testing::Test {
 protected:
  LiveCrowd crowd(std::size_t places, Pace pace) const { return {feed_.read(), places, {}, pace}; }

  /// Goes on for some seconds of a run, all rows of which were sent.
  static void go_on(LiveCrowd& crowd, double seconds) {
    for (double passed = 0.0; passed < seconds; passed += frame) {
      ASSERT_TRUE(crowd.can_go_on(frame, std::chrono::seconds(20)));
      static_cast<void>(crowd.advance(frame));
    }
  }
  /// Returns the people who have a row in the second around the crowd's time.
  static std::vector<std::string> people_of(const LiveCrowd& crowd) {
    std::vector<std::string> ids;
    for (const PersonTrack& person : crowd.trajectories()->persons) {
      const bool is_there = !person.rows.empty() && person.rows.front().seconds <= crowd.seconds() &&
                            person.rows.back().seconds >= crowd.seconds();
      if (is_there) ids.push_back(person.id);
    }
    return ids;
  }
  static std::string said_of(const LiveCrowd& crowd) {
    std::string all;
    for (const std::string& sentence : crowd.remarks()) all += sentence + "\n";
    return all;
  }

  LiveFeed feed_;
};

TEST_F(LiveCrowds, HaveSomebodyAsSoonAsTheFirstRowIsThere) {
  feed_.send(header + row("ann", 5.0));
  LiveCrowd crowd = this->crowd(3, Pace::of_the_rows);
  const LiveStep step = crowd.advance(frame);
  EXPECT_THAT(step.changed, ElementsAre(0U));
  EXPECT_EQ(crowd.seconds(), 5.0);
  EXPECT_THAT(people_of(crowd), ElementsAre("ann"));
  EXPECT_TRUE(crowd.trajectories()->persons[1].rows.empty());
}

TEST_F(LiveCrowds, WaitForTheRowsAheadInARunOfItsOwnPace) {
  feed_.send(header + rows("ann", 0.0, 0.5));
  LiveCrowd crowd = this->crowd(2, Pace::of_the_run);
  EXPECT_FALSE(crowd.can_go_on(frame, soon));
  feed_.send(rows("ann", 0.5, 0.75));
  ASSERT_TRUE(crowd.can_go_on(frame, std::chrono::seconds(20)));
  const LiveStep step = crowd.advance(frame);
  EXPECT_EQ(step.clock.rate, 1.0);
  EXPECT_DOUBLE_EQ(crowd.seconds(), frame);
  EXPECT_EQ(crowd.trajectories()->persons[0].rows.size(), 6U);  // those half a second ahead
}

TEST_F(LiveCrowds, GivePlacesOnToWhoComesNextAndToWhoComesBack) {
  std::string text = header;
  for (int i = 0; i < 90; ++i) {
    const double seconds = 0.1 * i;
    if (seconds < 1.0) text += row("a", seconds);
    text += row("b", seconds);
    if (seconds >= 3.0 && seconds < 4.0) text += row("c", seconds);
    if (seconds >= 6.0) text += row("a", seconds);
  }
  feed_.send_all(text);
  LiveCrowd crowd = this->crowd(2, Pace::of_the_run);
  go_on(crowd, 0.5);
  EXPECT_THAT(people_of(crowd), ElementsAre("a", "b"));
  go_on(crowd, 1.5);
  EXPECT_THAT(people_of(crowd), ElementsAre("b"));
  go_on(crowd, 1.5);
  EXPECT_THAT(people_of(crowd), ElementsAre("c", "b"));
  EXPECT_EQ(crowd.trajectories()->persons[0].rows.front().seconds, 3.0);
  go_on(crowd, 3.0);
  EXPECT_THAT(people_of(crowd), ElementsAre("a", "b"));
  EXPECT_THAT(said_of(crowd), IsEmpty());
  while (!crowd.has_ended()) go_on(crowd, frame);
  EXPECT_THAT(people_of(crowd), ElementsAre("a", "b"));
}

TEST_F(LiveCrowds, StandAtAWindowWhenTheInputHasEnded) {
  feed_.send_all(header + rows("a", 0.0, 1.0));
  LiveCrowd crowd = this->crowd(2, Pace::of_the_rows);
  for (int i = 0; i < 10'000 && !crowd.has_ended(); ++i) {
    EXPECT_THAT(said_of(crowd), IsEmpty());
    static_cast<void>(crowd.advance(frame));
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  EXPECT_NEAR(crowd.seconds(), 0.9, 1e-6);
  EXPECT_THAT(people_of(crowd), ElementsAre("a"));
  EXPECT_THAT(said_of(crowd), HasSubstr("The input has ended"));
}

TEST_F(LiveCrowds, SayWhoFoundNoPlaceAndWhichRowsCameLate) {
  std::string text = header;
  for (int i = 0; i < 30; ++i) text += row("a", 0.1 * i) + row("b", 0.1 * i) + row("c", 0.1 * i);
  feed_.send_all(text + row("d", 0.5) + row("a", 1.0));
  LiveCrowd crowd = this->crowd(2, Pace::of_the_run);
  while (!crowd.has_ended()) go_on(crowd, frame);
  EXPECT_THAT(said_of(crowd), HasSubstr("-: One person found no place among the 2; --agents makes more."));
  EXPECT_THAT(said_of(crowd), HasSubstr("-: One row came too late to be shown"));
  EXPECT_THAT(said_of(crowd), HasSubstr("-: One row was left out, for the person has one of that time or later"));
}

TEST_F(LiveCrowds, RefuseRowsThatComePersonByPerson) {
  feed_.send_all(header + rows("a", 0.0, 5.0) + rows("b", 0.0, 5.0) + rows("c", 0.0, 5.0));
  LiveCrowd crowd = this->crowd(3, Pace::of_the_run);
  while (!crowd.has_ended()) go_on(crowd, frame);
  ASSERT_FALSE(crowd.status());
  EXPECT_THAT(crowd.status().error().message, HasSubstr("rows came too late to be shown; send rows in the order"));
}

TEST_F(LiveCrowds, StayAsTheyAreWhereTheTextIsWrong) {
  feed_.send(header + rows("a", 0.0, 2.0) + "a,2,far,0\n");
  LiveCrowd crowd = this->crowd(2, Pace::of_the_run);
  while (!crowd.has_ended()) go_on(crowd, frame);
  EXPECT_THAT(people_of(crowd), ElementsAre("a"));
  EXPECT_THAT(said_of(crowd), HasSubstr("-: line 22: \"far\" is not a number"));
}

TEST_F(LiveCrowds, KeepRowsOfTheLastSecondsAlone) {
  feed_.send_all(header + rows("a", 0.0, 60.0));
  LiveCrowd crowd = this->crowd(1, Pace::of_the_run);
  go_on(crowd, 50.0);
  const std::vector<TrackRow>& kept = crowd.trajectories()->persons[0].rows;
  EXPECT_LE(kept.front().seconds, 40.0);
  EXPECT_GT(kept.front().seconds, 30.0);
  EXPECT_LT(kept.size(), 200U);
}

// A clock that rows of every tenth of a second reach as frames pass.
TEST_F(LiveCrowds, RunHalfASecondBehindRowsThatComeInTime) {
  feed_.send(header + row("a", 0.0));
  LiveCrowd crowd = this->crowd(1, Pace::of_the_rows);
  double sent = 0.0, least = 1.0, most = 1.0;
  for (int i = 1; i <= 600; ++i) {
    if (sent + 0.1 < i * frame) {
      sent += 0.1;
      feed_.send(row("a", sent));
      crowd.wait(std::chrono::seconds(20));
    }
    const double rate = crowd.advance(frame).clock.rate;
    if (i < 300) continue;
    least = std::min(least, rate), most = std::max(most, rate);
  }
  EXPECT_NEAR(10.0 - crowd.seconds(), 0.6, 0.15);
  EXPECT_GT(least, 0.8);
  EXPECT_LT(most, 1.2);
}

TEST_F(LiveCrowds, StandWhereRowsFailToComeAndGoOnWithThem) {
  feed_.send(header + rows("a", 0.0, 2.0));
  LiveCrowd crowd = this->crowd(1, Pace::of_the_rows);
  TrackClock clock;
  for (int i = 0; i < 60; ++i) clock = crowd.advance(frame).clock;
  EXPECT_EQ(clock.stands, 0.0F);
  for (int i = 0; i < 240; ++i) clock = crowd.advance(frame).clock;
  EXPECT_EQ(clock.stands, 1.0F);
  EXPECT_LT(crowd.seconds(), 1.9);
  feed_.send(rows("a", 2.0, 3.0));
  crowd.wait(soon);
  for (int i = 0; i < 30; ++i) clock = crowd.advance(frame).clock;
  EXPECT_EQ(clock.stands, 0.0F);
}

TEST(LiveRate, IsOneWhereRowsComeInTimeAndElseChangesSmoothly) {
  EXPECT_EQ(live_rate(0.0, 0.04, 0.5, true), 1.0);
  EXPECT_EQ(live_rate(0.03, 0.04, 0.5, true), 1.0);
  EXPECT_NEAR(live_rate(0.54, 0.04, 0.5, true), 1.5, 1e-9);
  EXPECT_EQ(live_rate(60.0, 0.04, 0.5, true), 3.0);
  EXPECT_EQ(live_rate(60.0, 0.04, 0.5, false), 1.0);
  EXPECT_NEAR(live_rate(-0.125, 0.04, 0.5, true), 0.5, 1e-9);
  EXPECT_EQ(live_rate(-0.5, 0.04, 0.5, true), 0.0);
}

}  // namespace
}  // namespace throng::live_crowd_test
