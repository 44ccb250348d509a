#include "app/window/frame_reporter.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::frame_reporter_test {
namespace {

class ReportedShow : public testing::Test {
 protected:
  void pass(int frames, double frame_ms) {
    for (int i = 0; i < frames; ++i) {
      show_->animate(test::sixtieth);
      reporter_.update(*show_, {}, frame_ms);
    }
  }

  std::unique_ptr<Show> show_ = test::show_of(test::demo("--agents 60 --pus 2"));
  FrameReporter reporter_{*show_};
  const FrameReport& report_ = reporter_.report();
};

TEST_F(ReportedShow, HasTheErrorWithItsIntervalAndItsHistoryWithinASecond) {
  pass(60, 10);
  EXPECT_TRUE(report_.error.figures.p99_is_known());
  EXPECT_TRUE(report_.error.intervals.p99.high);
  EXPECT_EQ(report_.error.p99_history.size(), 30U);
  EXPECT_EQ(report_.error.pop_history.size(), 30U);
}

TEST_F(ReportedShow, KnowsWhatMakesValuesIdle) {
  pass(1, 10);
  EXPECT_FALSE(report_.situation.selected);
  EXPECT_TRUE(report_.situation.places_feet);
  EXPECT_TRUE(report_.situation.can_pack);
  EXPECT_EQ(report_.situation.bone_levels, 3);
  EXPECT_EQ(report_.situation.mesh_levels, 1) << "nothing is drawn";
  EXPECT_TRUE(show_->take(Select{3}));
  pass(1, 10);
  EXPECT_TRUE(report_.situation.selected);
}

TEST_F(ReportedShow, ShowsASlowFrameAfterItHasPassed) {
  pass(20, 10);
  pass(1, 200);
  const int slow = report_.frame;
  pass(40, 10);
  reporter_.look_at(slow + 1);
  pass(1, 10);
  ASSERT_TRUE(report_.kept.looked_at);
  const FrameDetails& frame = *report_.kept.looked_at;
  EXPECT_EQ(frame.number(), slow);
  EXPECT_EQ(frame.frame_ms, 200);
  EXPECT_GT(frame.work.agents_updated, 0U);
  EXPECT_GT(frame.tiles(), 0U);
  EXPECT_EQ(frame.pu.size(), 2U);
  EXPECT_EQ(frame.timeline.lanes.size(), 2U);
  reporter_.look_at_last();
  pass(1, 10);
  EXPECT_FALSE(report_.kept.looked_at);
}

TEST_F(ReportedShow, HasTheNumbersOfAgentsAboveHeadsWhereTheyAreAskedFor) {
  pass(1, 10);
  EXPECT_TRUE(report_.heads.empty());
  test::change(*show_, [](Tuning& tuning) { tuning.ids = true; });
  pass(1, 10);
  ASSERT_FALSE(report_.heads.empty());
  for (const HeadFigures& head : report_.heads) {
    EXPECT_EQ(head.id, std::to_string(head.agent));
    EXPECT_EQ(head.interval, 0) << "figures are not asked for";
  }
  test::change(*show_, [](Tuning& tuning) { tuning.ids = false, tuning.inspection.figures_above_heads = true; });
  pass(1, 10);
  ASSERT_FALSE(report_.heads.empty());
  EXPECT_EQ(report_.heads.front().id, "");
  EXPECT_GT(report_.heads.front().interval, 0);
}

TEST(ReportedTracks, HaveTheIdsOfTheirFileAboveHeads) {
  const std::string crossing = std::string(THRONG_SOURCE_DIR) + "/assets/samples/crossing.txt";
  const auto show = test::show_of(test::demo("--ids on --start 5 --trajectories " + crossing));
  FrameReporter reporter(*show);
  show->animate(test::sixtieth);
  reporter.update(*show, {}, 10);
  ASSERT_FALSE(reporter.report().heads.empty());
  for (const HeadFigures& head : reporter.report().heads)
    EXPECT_EQ(head.id, show->stage().trajectories()->persons[head.agent].id);
}

}  // namespace
}  // namespace throng::app::frame_reporter_test
