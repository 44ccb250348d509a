#include "app/show/figures/run_figures.h"

#include <gtest/gtest.h>

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::run_figures_test {
namespace {

TEST(RunFigures, JoinTheTimeOfTheUpdateWithThatOfTheDrawing) {
  const auto show = test::show_of(test::demo("--agents 3"));
  RunFigures figures;
  figures.add_update(show->stage(), RunFigures::Clock::now(), 5.0);
  figures.add_drawing(RunFigures::Clock::now(), {.upload_ms = 1, .submission_ms = 2, .wait_ms = 4}, {});
  EXPECT_EQ(figures.times().animation_ms, 5.0);
  EXPECT_EQ(figures.times().drawing_ms(), 7.0);
}

TEST(RunFigures, KeepATimelineOnlyWhenTheyAreAsked) {
  RunFigures figures;
  EXPECT_FALSE(figures.timeline());
  figures.keep_timeline();
  EXPECT_TRUE(figures.timeline());
}

}  // namespace
}  // namespace throng::app::run_figures_test
