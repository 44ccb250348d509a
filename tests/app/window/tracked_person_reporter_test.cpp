// A person of a recorded crowd that is selected is reported.
#include "app/window/tracked_person_reporter.h"

#include <fstream>

#include <gtest/gtest.h>

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::tracked_person_reporter_test {
namespace {

/// Somebody walks 1.2 m/s for 20 s, and somebody else has one row.
class ReportedPerson : public test::TemporaryFolder {
 protected:
  ReportedPerson() {
    const std::filesystem::path walk = folder_ / "walk.csv";
    std::ofstream file(walk);
    file << "id,time,x,y\n";
    for (int row = 0; row <= 200; ++row) file << "71," << 0.1 * row << ',' << 100.0 + 0.12 * row << ",50\n";
    file << "72,4,103,55\n";
    file.close();
    show_ = test::show_of(test::demo("--trajectories " + walk.string()));
  }
  std::shared_ptr<const TrackedPerson> report_of(std::uint32_t agent) {
    EXPECT_TRUE(show_->take(Select{agent}));
    return reporter_.report(show_->stage());
  }

  std::unique_ptr<Show> show_;
  TrackedPersonReporter reporter_;
};

TEST_F(ReportedPerson, IsNobodyWhereNobodyIsSelected) { EXPECT_EQ(reporter_.report(show_->stage()), nullptr); }

TEST_F(ReportedPerson, HasWhatTheFileSays) {
  const auto person = report_of(0);
  EXPECT_EQ(person->id, "71");
  EXPECT_EQ(person->rows, 201U);
  EXPECT_EQ(person->presence.first, 0.0);
  EXPECT_NEAR(person->presence.last, 20.0, 1e-9);
  EXPECT_NEAR(person->stature, 1.75, 0.3);
}

TEST_F(ReportedPerson, HasSpeedAndWayAllAlong) {
  const auto person = report_of(0);
  for (const double seconds : {0.5, 5.0, 19.0}) EXPECT_NEAR(person->speed_at(seconds), 1.2F, 0.01F);
  EXPECT_NEAR(person->way_at(10.0), 12.0F, 0.05F);
  EXPECT_NEAR(person->ways.back(), 24.0F, 0.05F);
}

TEST_F(ReportedPerson, StepsLeftAndRightInTurnAsTheLegsGo) {
  const auto person = report_of(0);
  ASSERT_TRUE(person->has_all_footfalls) << "20 s are looked through in a frame";
  ASSERT_GT(person->footfalls.size(), 20U);
  for (std::size_t i = 1; i < person->footfalls.size(); ++i) {
    EXPECT_NE(person->footfalls[i].is_left, person->footfalls[i - 1].is_left) << "step " << i;
    const double step = person->footfalls[i].seconds - person->footfalls[i - 1].seconds;
    EXPECT_GT(step, 0.3);
    EXPECT_LT(step, 0.9);
  }
  const Followers& followers = show_->stage().crowd().tracks()->people();
  const double cycles = followers.step(0, 20.0).cycles - followers.step(0, 0.0).cycles;
  EXPECT_NEAR(static_cast<double>(person->footfalls.size()), 2.0 * cycles, 1.5);
}

TEST_F(ReportedPerson, OfOneRowStands) {
  const auto person = report_of(1);
  EXPECT_EQ(person->id, "72");
  EXPECT_TRUE(person->footfalls.empty());
  EXPECT_EQ(person->ways.back(), 0.0F);
  EXPECT_EQ(person->speed_at(4.0), 0.0F);
}

}  // namespace
}  // namespace throng::app::tracked_person_reporter_test
