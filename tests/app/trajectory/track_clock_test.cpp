// The time of a recorded crowd.

#include "app/trajectory/track_clock.h"

#include <gtest/gtest.h>

namespace throng::app::track_clock_test {
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

}  // namespace
}  // namespace throng::app::track_clock_test
