// People of a recorded crowd who pass a line.

#include "app/people/measure/line_counts.h"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace throng::app::line_counts_test {
namespace {

/// People who have a row each second, at (x, y) from the file's place (100, 50).
Trajectories people(const std::vector<std::vector<std::pair<float, float>>>& ways) {
  Trajectories all;
  all.origin = {100.0, 50.0};
  for (const auto& way : ways) {
    PersonTrack track{.id = "", .rows = {}};
    for (const auto& [x, y] : way) {
      track.rows.push_back({.seconds = static_cast<double>(track.rows.size()), .x = x, .z = -y});
    }
    all.persons.push_back(std::move(track));
  }
  return all;
}

/// The ends of a line along the file's x. Seen from the west, the left is where y is greater.
constexpr glm::dvec2 west(100.0, 50.0), east(104.0, 50.0);

std::pair<std::size_t, std::size_t> counts_of(const Trajectories& tracks, double first = 0.0, double last = 100.0) {
  const LineCounts counts = count_passages(tracks, west, east, first, last);
  return {counts.to_left, counts.to_right};
}

using Counts = std::pair<std::size_t, std::size_t>;

TEST(LineCounts, AreOfBothDirectionsSeenFromTheBeginning) {
  const Trajectories tracks = people({{{1, -1}, {1, 1}}, {{2, -1}, {2, 1}}, {{3, 1}, {3, -1}}});
  EXPECT_EQ(counts_of(tracks), Counts(2, 1));
  EXPECT_EQ(count_passages(tracks, east, west, 0.0, 100.0).to_left, 1U) << "from the other end";
}

TEST(LineCounts, LeaveOutPeopleWhoPassBesideTheLine) {
  EXPECT_EQ(counts_of(people({{{-0.1F, -1}, {-0.1F, 1}}, {{4.1F, -1}, {4.1F, 1}}})), Counts(0, 0));
  EXPECT_EQ(counts_of(people({{{-1, -1}, {1, 1}}, {{-1.1F, -1}, {0.9F, 1}}})), Counts(1, 0)) << "aslant";
}

TEST(LineCounts, HaveAPersonWhoStandsOnTheLineInARowOnce) {
  EXPECT_EQ(counts_of(people({{{1, -1}, {1, 0}, {2, 0}, {2, 1}}})), Counts(1, 0));
  EXPECT_EQ(counts_of(people({{{1, 1}, {1, 0}, {1, -1}}})), Counts(0, 1));
  EXPECT_EQ(counts_of(people({{{1, -1}, {1, 0}, {1, -1}}})), Counts(0, 0)) << "it turns back on the line";
}

TEST(LineCounts, HaveAPersonWhoComesBackOnBothSides) {
  EXPECT_EQ(counts_of(people({{{1, -1}, {1, 1}, {1, -1}, {1, 1}}})), Counts(2, 1));
}

TEST(LineCounts, LeaveOutJumpsAndWhatIsOutsideOfThePart) {
  EXPECT_EQ(counts_of(people({{{1, -7}, {1, 7}}})), Counts(0, 0)) << "14 m in a second";
  const Trajectories tracks = people({{{1, -1}, {1, 3}}});  // it passes after a quarter of a second
  EXPECT_EQ(counts_of(tracks, 0.2, 0.3), Counts(1, 0));
  EXPECT_EQ(counts_of(tracks, 0.3, 1.0), Counts(0, 0));
  EXPECT_EQ(counts_of(tracks, 0.0, 0.2), Counts(0, 0));
  EXPECT_EQ(count_passages(tracks, west, east, 0.25, 0.75).seconds, 0.5);
}

}  // namespace
}  // namespace throng::app::line_counts_test
