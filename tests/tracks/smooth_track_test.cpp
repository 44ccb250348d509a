// Somebody's way between the rows of a file.

#include "engine/tracks/smooth_track.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace throng::smooth_track_test {
namespace {

std::vector<TrackRow> circle(double rows_a_second) {
  std::vector<TrackRow> rows;
  for (int i = 0; i < static_cast<int>(20.0 * rows_a_second); ++i) {
    const double seconds = i / rows_a_second, angle = 0.26 * seconds;  // 1.3 m/s at 5 m
    rows.push_back({.seconds = seconds,
                    .x = static_cast<float>(5.0 * std::cos(angle)),
                    .z = static_cast<float>(5.0 * std::sin(angle))});
  }
  return rows;
}

TEST(SmoothTrack, GoesThroughEveryRow) {
  for (const double rate : {0.4, 2.5, 16.0, 25.0, 60.0}) {
    const std::vector<TrackRow> rows = circle(rate);
    const SmoothTrack track(rows);
    for (const TrackRow& row : rows) {
      EXPECT_LT(glm::distance(track.position(row.seconds), glm::vec3(row.x, row.y, row.z)), 1e-4F) << rate;
    }
  }
}

TEST(SmoothTrack, IsNearTheWayThatWasWalkedBetweenRowsFarApart) {
  const std::vector<TrackRow> rows = circle(0.4);
  const SmoothTrack track(rows);
  for (double seconds = 0.0; seconds < 17.5; seconds += 0.1) {
    const glm::vec3 place = track.position(seconds);
    EXPECT_NEAR(std::hypot(place.x, place.z), 5.0F, 0.1F) << "a straight line is off by 0.26: " << seconds;
  }
}

TEST(SmoothTrack, SomebodyWhoStopsDoesNotGoBeyond) {
  std::vector<TrackRow> rows;
  for (int i = 0; i < 20; ++i) rows.push_back({.seconds = 0.4 * i, .x = 0.5F * static_cast<float>(std::min(i, 10))});
  const SmoothTrack track(rows);
  for (double seconds = 0.0; seconds < 7.6; seconds += 0.01) {
    EXPECT_LE(track.position(seconds).x, 5.0F) << seconds;
    EXPECT_GE(track.position(seconds + 0.01).x, track.position(seconds).x) << "nobody walks back at " << seconds;
  }
}

TEST(SmoothTrack, BetweenTwoRowsNobodyIsFartherAsideThanHalfOfTheirDistance) {
  std::vector<TrackRow> rows;
  for (int i = 0; i < 9; ++i) {  // a sharp corner after each row
    rows.push_back({.seconds = 1.0 * i, .x = static_cast<float>(i / 2), .z = static_cast<float>((i + 1) / 2)});
  }
  const SmoothTrack track(rows);
  for (double seconds = 0.0; seconds < 8.0; seconds += 0.02) {
    const TrackRow& from = rows[static_cast<std::size_t>(seconds)];
    const TrackRow& to = rows[static_cast<std::size_t>(seconds) + 1];
    const glm::vec2 along(to.x - from.x, to.z - from.z), place(track.position(seconds).x, track.position(seconds).z);
    const glm::vec2 way = place - glm::vec2(from.x, from.z);
    EXPECT_LE(std::abs(way.x * along.y - way.y * along.x) / glm::length(along), 0.5F) << seconds;
  }
}

TEST(SmoothTrack, VelocityIsWithoutTheSwayOfAHead) {
  std::vector<TrackRow> rows;
  for (int i = 0; i < 250; ++i) {
    const double seconds = i / 25.0;
    rows.push_back({.seconds = seconds,
                    .x = static_cast<float>(0.04 * std::sin(6.28 * 1.25 * seconds)),
                    .z = static_cast<float>(1.2 * seconds)});
  }
  const SmoothTrack track(rows);
  for (double seconds = 1.0; seconds < 9.0; seconds += 0.03) {
    EXPECT_NEAR(track.velocity(seconds, 0.8).x, 0.0F, 0.01F);
    EXPECT_NEAR(track.velocity(seconds, 0.8).y, 1.2F, 0.01F);
  }
}

TEST(SmoothTrack, WhoWasLostAndFoundAgainJumpsAndDoesNotFly) {
  const std::vector<TrackRow> rows{
      {.seconds = 0.0, .x = 0.0F}, {.seconds = 0.1, .x = 0.1F}, {.seconds = 0.2, .x = 9.0F}};
  const SmoothTrack track(rows);
  EXPECT_FLOAT_EQ(track.position(0.14).x, 0.1F);
  EXPECT_FLOAT_EQ(track.position(0.16).x, 9.0F);
}

TEST(SmoothTrack, HeadingsTakeTheShorterWay) {
  const std::vector<TrackRow> rows{{.seconds = 0.0, .heading = 3.0F}, {.seconds = 1.0, .heading = -3.0F}};
  EXPECT_NEAR(std::abs(wrapped_angle(SmoothTrack(rows).heading(0.5))), 3.1416F, 1e-3F);
}

}  // namespace
}  // namespace throng::smooth_track_test
