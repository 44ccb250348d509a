// People of a recorded crowd look where they walk, and make as many steps as that takes.

#include "app/people/crowd/track_steps.h"

#include <cmath>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace throng::app::track_steps_test {
namespace {

StridePlane plane() {
  const auto gait = [](int clip, const glm::vec2& velocity, double seconds) {
    return StridePoint{.gait = {.clip = clip, .velocity = velocity}, .seconds = seconds};
  };
  return StridePlane({{.gait = {.is_gait = false}},
                      gait(1, {0.0F, 1.3F}, 1.0),
                      gait(2, {0.0F, 3.0F}, 0.7),
                      gait(3, {0.6F, 0.0F}, 1.0),
                      gait(4, {-0.6F, 0.0F}, 1.0),
                      gait(5, {0.0F, -0.8F}, 1.0)});
}

/// Rows that go from the origin at a velocity, 25 a second.
std::vector<TrackRow> straight(const glm::vec2& velocity, double seconds) {
  std::vector<TrackRow> rows;
  for (double t = 0.0; t < seconds; t += 0.04) {
    rows.push_back({.seconds = t, .x = velocity.x * static_cast<float>(t), .z = velocity.y * static_cast<float>(t)});
  }
  return rows;
}

TEST(StridePlane, SlowPeopleTakeShorterStepsAndFewerOfThem) {
  const auto walk = plane().stride({0.0F, 1.3F}), slow = plane().stride({0.0F, 0.325F});
  EXPECT_NEAR(walk.cycles_per_second, 1.0, 1e-5);
  EXPECT_NEAR(slow.cycles_per_second, 0.5, 1e-5) << "the root of a quarter";
  EXPECT_NEAR(0.325 / slow.cycles_per_second, 0.65, 1e-5) << "half of the walk's stride";
}

TEST(StridePlane, WhoStandsMakesNoStep) {
  EXPECT_EQ(plane().stride({0.0F, 0.0F}).cycles_per_second, 0.0);
  EXPECT_EQ(plane().stride({0.0F, 0.0F}).stands, 1.0F);
  EXPECT_EQ(plane().stride({0.0F, 1.0F}).stands, 0.0F);
}

TEST(TrackSteps, PeopleLookWhereTheyWalk) {
  for (const float angle : {0.0F, 1.0F, 2.5F, -2.0F}) {
    const auto rows = straight(1.2F * glm::vec2(std::sin(angle), std::cos(angle)), 4.0);
    const SmoothTrack track(rows);
    const TrackSteps steps(track, plane(), 1.0F, 0.0F);
    const TrackStep at = steps.at(2.0);
    EXPECT_NEAR(at.heading, angle, 1e-3F);
    EXPECT_NEAR(at.velocity.x, 0.0F, 1e-3F);
    EXPECT_NEAR(at.velocity.y, 1.2F, 1e-2F);
  }
}

TEST(TrackSteps, StridesAddUpToTheWay) {
  const auto rows = straight({0.0F, 1.3F}, 10.0);
  const SmoothTrack track(rows);
  const TrackSteps steps(track, plane(), 1.0F, 0.0F);
  EXPECT_NEAR(steps.at(8.0).cycles - steps.at(2.0).cycles, 6.0, 0.02);
}

TEST(TrackSteps, OfRowsYearsApartTakeLittleMemory) {
  const std::vector<TrackRow> rows{{.seconds = 0.0}, {.seconds = 1e9, .x = 1.0F}};
  const SmoothTrack track(rows);
  const TrackSteps steps(track, plane(), 1.0F, 0.5F);
  EXPECT_NEAR(glm::length(steps.at(5e8).velocity), 0.0F, 1e-3F);
  EXPECT_TRUE(std::isfinite(steps.at(5e8).cycles));
}

// Somebody walks round in a circle, and rows come two at a time.
TEST(TrackSteps, KeepWhatWasShownWhileRowsComeAndComeToTheSame) {
  std::vector<TrackRow> rows;
  for (double t = 0.0; t < 20.0; t += 0.04) {
    const auto angle = static_cast<float>(t) * 0.6F;
    rows.push_back({.seconds = t, .x = 2.0F * std::sin(angle), .z = 2.0F * std::cos(angle)});
  }
  const SmoothTrack whole(rows);
  const TrackSteps all(whole, plane(), 1.0F, 0.0F);
  TrackSteps steps;
  for (std::size_t end = 25; end < rows.size(); end += 2) {
    const std::size_t begin = end > 300 ? end - 300 : 0;  // what is old is forgotten
    const SmoothTrack track(std::span<const TrackRow>(rows).subspan(begin, end - begin));
    const double shown = track.last() - 0.5;
    const TrackStep before = steps.at(shown);
    steps.extend(track, plane(), 1.0F, 0.0F, shown);
    if (end > 25) {
      ASSERT_EQ(steps.at(shown).heading, before.heading) << shown;
      ASSERT_EQ(steps.at(shown).cycles, before.cycles) << shown;
    }
    ASSERT_NEAR(steps.at(shown).heading, all.at(shown).heading, 0.02F) << shown;
    ASSERT_NEAR(steps.at(shown).cycles, all.at(shown).cycles, 0.02) << shown;
  }
}

TEST(TrackSteps, TallPeopleTakeLongerSteps) {
  const auto rows = straight({0.0F, 1.3F}, 10.0);
  const SmoothTrack track(rows);
  const auto strides = [&](float scale) {
    const TrackSteps steps(track, plane(), scale, 0.0F);
    return steps.at(8.0).cycles - steps.at(2.0).cycles;
  };
  EXPECT_LT(strides(1.15F), strides(1.0F));
  EXPECT_GT(strides(0.85F), strides(1.0F));
}

TEST(TrackSteps, WhoStandsKeepsTheHeadingAndSways) {
  std::vector<TrackRow> rows = straight({1.2F, 0.0F}, 2.0);
  const TrackRow last = rows.back();
  for (int i = 1; i < 150; ++i) {  // a head that is never quite still
    rows.push_back({.seconds = last.seconds + 0.04 * i,
                    .x = last.x + 0.02F * std::sin(0.1F * static_cast<float>(i)),
                    .z = last.z + 0.02F * std::cos(0.07F * static_cast<float>(i)) - 0.02F});
  }
  const SmoothTrack track(rows);
  const TrackSteps steps(track, plane(), 1.0F, 0.0F);
  EXPECT_NEAR(steps.at(7.0).heading, 1.5708F, 0.1F);
  EXPECT_NEAR(steps.at(7.0).cycles, steps.at(4.5).cycles, 0.2);
}

TEST(TrackSteps, AHeadingOfTheFileMakesSideStepsAndStepsBack) {
  std::vector<TrackRow> rows = straight({0.0F, -0.5F}, 4.0);
  for (TrackRow& row : rows) row.heading = 0.0F;
  const SmoothTrack back(rows);
  EXPECT_NEAR(TrackSteps(back, plane(), 1.0F, 0.0F).at(2.0).velocity.y, -0.5F, 0.02F);
  for (TrackRow& row : rows) row.heading = 1.5708F;  // looks along +X and goes along -Z, which is to its left
  const SmoothTrack aside(rows);
  EXPECT_NEAR(TrackSteps(aside, plane(), 1.0F, 0.0F).at(2.0).velocity.x, 0.5F, 0.02F);
}

TEST(TrackSteps, SomebodyWhoIsPushedBackForAMomentDoesNotTurnRound) {
  std::vector<TrackRow> rows = straight({0.0F, 1.0F}, 3.0);
  const TrackRow turned = rows.back();
  for (int i = 1; i <= 20; ++i) {
    rows.push_back({.seconds = turned.seconds + 0.04 * i, .x = 0.0F, .z = turned.z - 0.01F * static_cast<float>(i)});
  }
  for (int i = 1; i <= 50; ++i) {
    rows.push_back(
        {.seconds = turned.seconds + 0.8 + 0.04 * i, .x = 0.0F, .z = turned.z - 0.2F + 0.04F * static_cast<float>(i)});
  }
  const SmoothTrack track(rows);
  const TrackSteps steps(track, plane(), 1.0F, 0.0F);
  for (double seconds = 0.0; seconds < 5.5; seconds += 0.1) {
    EXPECT_NEAR(wrapped_angle(steps.at(seconds).heading), 0.0F, 0.5F) << seconds;
  }
}

}  // namespace
}  // namespace throng::app::track_steps_test
