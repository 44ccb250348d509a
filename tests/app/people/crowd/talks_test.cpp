// People of a recorded crowd who stand near each other talk, and look elsewhere when one of them leaves.

#include "app/people/crowd/talks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace throng::app::talks_test {
namespace {

constexpr float left = std::numbers::pi_v<float> / 2.0F, right = -left, behind = 2.0F * left;

/// Somebody who walks up from afar until second 4, stands at (x, z), and walks off at a time.
/// The file's clock says `begin` more.
std::vector<TrackRow> visit(float x, float z, float heading, double until = 40.0, double begin = 0.0) {
  std::vector<TrackRow> rows;
  for (double t = 0.0; t <= 44.0; t += 0.2) {
    const double away = std::max({0.0, 4.0 - t, t - until});
    rows.push_back({.seconds = begin + t, .x = x, .z = z + 1.2F * static_cast<float>(away), .heading = heading});
  }
  return rows;
}

class SmallCrowd {
 public:
  explicit SmallCrowd(const std::vector<std::vector<TrackRow>>& people) : rows_(people) {
    const StridePlane plane({{.gait = {.is_gait = false}}, {.gait = {.clip = 1, .velocity = {0.0F, 1.3F}}}});
    for (const auto& rows : rows_) {
      tracks_.emplace_back(rows);
      steps_.emplace_back(tracks_.back(), plane, 1.0F, 0.0F);
    }
    talks_ = Talks(tracks_, steps_);
  }

  TalkMoment at(std::size_t person, double seconds) const { return talks_.at(person, seconds); }
  /// Returns the share of the seconds from 8 to 36 in which a person does something.
  template <typename Does>
  double share(std::size_t person, Does does) const {
    int count = 0;
    for (int i = 0; i < 280; ++i) count += does(at(person, 8.0 + 0.1 * i)) ? 1 : 0;
    return count / 280.0;
  }

 private:
  std::vector<std::vector<TrackRow>> rows_;
  std::vector<SmoothTrack> tracks_;
  std::vector<TrackSteps> steps_;
  Talks talks_;
};

bool looks(const TalkMoment& moment) { return moment.looks > 0.5F; }
bool speaks(const TalkMoment& moment) { return moment.speaks > 0.5F; }

TEST(Talks, TwoWhoStandTogetherLookAtEachOtherAndSpeakInTurns) {
  const SmallCrowd crowd({visit(0.0F, 0.0F, left), visit(1.0F, 0.0F, right)});
  for (std::size_t person = 0; person < 2; ++person) {
    EXPECT_GT(crowd.share(person, looks), 0.6) << person;
    EXPECT_GT(crowd.share(person, speaks), 0.15) << person;
  }
  for (double t = 0.0; t < 44.0; t += 0.1) {
    const TalkMoment one = crowd.at(0, t), other = crowd.at(1, t);
    EXPECT_EQ(one.looks, other.looks) << t;
    EXPECT_TRUE(one.speaks == 0.0F || other.speaks == 0.0F) << t;
    if (looks(one)) {
      EXPECT_EQ(one.other, 1U);
      EXPECT_EQ(other.other, 0U);
    }
  }
}

TEST(Talks, NobodyTalksWhileWalkingOrAlone) {
  const SmallCrowd crowd({visit(0.0F, 0.0F, left, 20.0), visit(1.0F, 0.0F, right)});
  for (const double t : {0.0, 2.0, 4.0, 22.0, 30.0}) {
    EXPECT_EQ(crowd.at(0, t).looks, 0.0F) << t;
    EXPECT_EQ(crowd.at(1, t).looks, 0.0F) << t;
  }
}

TEST(Talks, ClocksMayCountFromLongAgo) {
  constexpr double today = 1.8e9;  // seconds since 1970
  const SmallCrowd crowd({visit(0.0F, 0.0F, left, 40.0, today), visit(1.0F, 0.0F, right, 40.0, today)});
  int count = 0;
  for (int i = 0; i < 280; ++i) count += looks(crowd.at(0, today + 8.0 + 0.1 * i)) ? 1 : 0;
  EXPECT_GT(count, 140);
}

TEST(Talks, RowsYearsApartDoNotSayWhoStands) {
  const std::vector<TrackRow> once_and_again{{.seconds = 0.0}, {.seconds = 1e9}};
  const std::vector<TrackRow> beside{{.seconds = 0.0, .x = 1.0F}, {.seconds = 1e9, .x = 1.0F}};
  EXPECT_EQ(SmallCrowd({once_and_again, beside}).at(0, 5e8).looks, 0.0F);
}

TEST(Talks, HeadsTurnSlowly) {
  const SmallCrowd crowd({visit(0.0F, 0.0F, left), visit(1.0F, 0.0F, right)});
  for (double t = 0.0; t < 44.0; t += 0.01) {
    EXPECT_LT(std::abs(crowd.at(0, t + 0.01).looks - crowd.at(0, t).looks), 0.03F) << t;
  }
}

TEST(Talks, WhoStandsTooFarTooNearOrBehindIsNotTalkedTo) {
  EXPECT_EQ(SmallCrowd({visit(0.0F, 0.0F, left), visit(1.8F, 0.0F, right)}).share(0, looks), 0.0);
  EXPECT_EQ(SmallCrowd({visit(0.0F, 0.0F, left), visit(0.4F, 0.0F, right)}).share(0, looks), 0.0);
  EXPECT_EQ(SmallCrowd({visit(0.0F, 0.0F, right), visit(1.0F, 0.0F, right)}).share(0, looks), 0.0);
  EXPECT_EQ(SmallCrowd({visit(0.0F, 0.0F, behind), visit(0.0F, 1.0F, behind)}).share(1, looks), 0.0) << "a queue";
}

TEST(Talks, AThirdPersonLooksAtOneOfTheOthersAndListens) {
  const SmallCrowd crowd({visit(0.0F, 0.0F, left), visit(1.0F, 0.0F, right), visit(0.5F, 0.9F, behind, 30.0)});
  EXPECT_GT(crowd.share(2, looks), 0.4);
  EXPECT_EQ(crowd.share(2, speaks), 0.0);
}

}  // namespace
}  // namespace throng::app::talks_test
