// People who follow a file are measured, and those of a scene.

#include "app/people/measure/crowd_measures.h"

#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "app/settings/choices.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::crowd_measures_test {
namespace {

/// Two people, 0.5 m apart, who walk side by side at 1.2 m/s, swaying; the second comes after 2 seconds.
std::shared_ptr<const Trajectories> two_people() {
  Trajectories all;
  for (int person = 0; person < 2; ++person) {
    PersonTrack track{.id = std::to_string(person), .rows = {}};
    for (int row = 50 * person; row <= 250; ++row) {
      const double seconds = 0.04 * row, sway = 0.05 * std::sin(2.0 * 3.14159265 * seconds / 0.8);
      track.rows.push_back({.seconds = seconds,
                            .x = static_cast<float>(1.2 * seconds),
                            .z = 0.5F * static_cast<float>(person) + static_cast<float>(sway)});
    }
    all.row_count += track.rows.size();
    all.persons.push_back(std::move(track));
  }
  all.rows_a_second = 25.0;
  all.last_seconds = 10.0;
  return std::make_shared<const Trajectories>(std::move(all));
}

class MeasuredCrowd : public testing::Test {
 protected:
  MeasuredCrowd() : roles_(person()), tracks_{two_people(), {StridePlane({StridePoint{}})}} {}

  CrowdMeasures taken(DebugView view, double seconds) {
    Crowd crowd(Scene::tracks, 2, 1, std::span(&roles_, 1), {}, tracks_);
    TrackClock clock = crowd.tracks()->clock();
    clock.seconds = seconds;
    crowd.go_to(clock);
    return taken_of(crowd, view);
  }
  CrowdMeasures taken_of(const Crowd& crowd, DebugView view) {
    tuning_.debug_view = view;
    CrowdMeasures measures;
    InOrder here;
    measures.take(crowd, tuning_, here, 1);
    return measures;
  }

  CharacterRoles roles_;
  TrackSource tracks_;
  Tuning tuning_;
};

TEST_F(MeasuredCrowd, SpeedIsThatOfTheWayWithoutSway) {
  // With it, somebody who sways by 5 cm each way in 0.8 s would go up to 1.26 m/s.
  for (const double seconds : {3.0, 3.1, 3.2, 3.3}) {
    EXPECT_NEAR(taken(DebugView::speed, seconds).of(0), 1.2F, 1e-3F) << seconds;
  }
}

TEST_F(MeasuredCrowd, SpeedIsKnownAtOnceAndToTheEnd) {
  EXPECT_NEAR(taken(DebugView::speed, 0.0).of(0), 1.2F, 0.05F);
  EXPECT_NEAR(taken(DebugView::speed, 10.0).of(1), 1.2F, 0.05F);
}

TEST_F(MeasuredCrowd, PresenceBeginsWithTheFirstRow) {
  const CrowdMeasures measures = taken(DebugView::presence, 7.25);
  EXPECT_NEAR(measures.of(0), 7.25F, 1e-4F);
  EXPECT_NEAR(measures.of(1), 5.25F, 1e-4F);
}

TEST_F(MeasuredCrowd, DensityIsOfThoseWhoAreThere) {
  EXPECT_NEAR(taken(DebugView::density, 1.0).of(0), 1.0F / 3.0F, 1e-4F);
  EXPECT_LT(taken(DebugView::density, 1.0).of(1), 0.0F);
  const CrowdMeasures both = taken(DebugView::density, 4.0);
  EXPECT_GT(both.of(0), 0.4F);
  EXPECT_NEAR(both.of(0), both.of(1), 1e-4F);
  tuning_.density_cut_off = 0.2F;
  EXPECT_NEAR(taken(DebugView::density, 4.0).of(0), 1.0F / 0.12F, 0.01F);
}

TEST_F(MeasuredCrowd, NothingIsKnownOfWhoHasNotComeYet) {
  for (const DebugView view : {DebugView::speed, DebugView::density, DebugView::presence}) {
    EXPECT_LT(taken(view, 1.0).of(1), 0.0F) << debug_view_words.at(static_cast<std::size_t>(view));
  }
}

TEST_F(MeasuredCrowd, NothingIsTakenWhereTheViewShowsNoMeasure) {
  EXPECT_LT(taken(DebugView::interval, 4.0).of(0), 0.0F);
  EXPECT_LT(taken(DebugView::none, 4.0).of(0), 0.0F);
}

TEST_F(MeasuredCrowd, AScenesPeopleHaveSpeedAndDensityButNeverAppear) {
  const Crowd crowd(Scene::plaza, 200, 1, roles_);
  const CrowdMeasures speeds = taken_of(crowd, DebugView::speed);
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) EXPECT_EQ(speeds.of(agent), crowd.speeds()[agent]);
  EXPECT_GT(taken_of(crowd, DebugView::density).of(0), 0.3F);
  EXPECT_LT(taken_of(crowd, DebugView::presence).of(0), 0.0F);
}

}  // namespace
}  // namespace throng::app::crowd_measures_test
