// The time of a recorded crowd.

#include "engine/tracks/track_clock.h"

#include <gtest/gtest.h>

namespace throng::track_clock_test {
namespace {

TEST(TrackClock, StaysAtTheEndOfItsPart) {
  TrackClock clock{.seconds = 9.0, .first = 2.0, .last = 10.0};
  advance(clock, 5.0);
  EXPECT_EQ(clock.seconds, 10.0);
  clock.rate = -2.0;
  advance(clock, 20.0);
  EXPECT_EQ(clock.seconds, 2.0);
}

TEST(TrackClock, RepeatsItsPartBothWays) {
  TrackClock clock{.seconds = 9.0, .first = 2.0, .last = 10.0, .repeats = true};
  advance(clock, 2.5);
  EXPECT_NEAR(clock.seconds, 3.5, 1e-12);
  clock.rate = -1.0;
  advance(clock, 2.5);
  EXPECT_NEAR(clock.seconds, 9.0, 1e-12);
}

TEST(TrackClock, APartWithoutLengthIsAMoment) {
  TrackClock clock{.seconds = 3.0, .first = 3.0, .last = 3.0, .repeats = true};
  advance(clock, 1.0);
  EXPECT_EQ(clock.seconds, 3.0);
}

TEST(TrackClock, GoesNoFartherThanItsPart) {
  const TrackClock clock{.seconds = 5.0, .first = 2.0, .last = 10.0};
  EXPECT_EQ(gone_to(clock, 7.0).seconds, 7.0);
  EXPECT_EQ(gone_to(clock, 99.0).seconds, 10.0);
  EXPECT_EQ(gone_to(clock, 0.0).seconds, 2.0);
}

TEST(TrackClock, TakesTheEndsOfAPartInAnyOrder) {
  const TrackClock part = with_part({.seconds = 5.0, .first = 0.0, .last = 10.0}, 9.0, 6.0);
  EXPECT_EQ(part.first, 6.0);
  EXPECT_EQ(part.last, 9.0);
  EXPECT_EQ(part.seconds, 6.0);
}

TEST(TrackClock, PlaysFromTheOtherEndWhereItWouldGoNoFurther) {
  const TrackClock at_end{.seconds = 10.0, .first = 2.0, .last = 10.0, .rate = 2.0};
  EXPECT_TRUE(has_ended(at_end));
  EXPECT_EQ(playing(at_end, false).seconds, 2.0);
  EXPECT_EQ(playing(at_end, true).seconds, 10.0);
  EXPECT_EQ(playing(at_end, true).rate, -2.0);
  EXPECT_EQ(playing(playing({.seconds = 2.0, .first = 2.0, .last = 10.0}, true), true).seconds, 10.0);
  TrackClock repeats = at_end;
  repeats.repeats = true;
  EXPECT_FALSE(has_ended(repeats));
}

TEST(TrackClock, StepsFromRowToRow) {
  EXPECT_NEAR(row_from(2.0, 0.0, 0.04, 1), 2.04, 1e-9);
  EXPECT_NEAR(row_from(2.0, 0.0, 0.04, -1), 1.96, 1e-9);
  EXPECT_NEAR(row_from(2.03, 0.0, 0.04, 1), 2.04, 1e-9) << "to the next row";
  EXPECT_NEAR(row_from(2.03, 0.0, 0.04, -1), 2.0, 1e-9);
}

}  // namespace
}  // namespace throng::track_clock_test
