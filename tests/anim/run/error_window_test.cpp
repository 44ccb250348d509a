#include "engine/anim/run/error_window.h"

#include <gtest/gtest.h>

namespace throng::anim {
namespace {

TEST(ErrorCounts, FindPercentilesThatAreNeverTooSmallAndTooLargeByOneStepAtMost) {
  ErrorCounts counts;
  for (int i = 1; i <= 1000; ++i) counts.add(ErrorCounts::step_of(static_cast<float>(i) * 0.01F));
  for (const double part : {0.01, 0.5, 0.9, 0.99, 1.0}) {
    const double exact = part * 10.0;
    EXPECT_GE(counts.percentile(part), exact * 0.9999) << part;
    EXPECT_LE(counts.percentile(part), exact * 1.032) << part;
  }
}

TEST(ErrorCounts, TakeWhatNobodySeesForNothingAndWhatIsHugeForTheLargest) {
  ErrorCounts counts;
  for (const float pixels : {0.0F, 1e-9F, 0.003F}) counts.add(ErrorCounts::step_of(pixels));
  EXPECT_EQ(counts.percentile(1.0), 0.0F);
  counts.add(ErrorCounts::step_of(1e9F));
  EXPECT_GT(counts.percentile(1.0), 10'000.0F);
}

TEST(ErrorWindow, HoldsSixtyFramesAndForgetsTheOldest) {
  ErrorWindow window;
  window.begin_frame();
  window.add({.error = 8.0F, .pop = 5.0F});
  for (std::size_t frame = 1; frame < ErrorWindow::frames; ++frame) {
    window.begin_frame();
    window.add({.error = 1.0F, .pop = 0.5F});
  }
  EXPECT_EQ(window.figures().samples, ErrorWindow::frames);
  EXPECT_EQ(window.figures().max, 8.0F);
  EXPECT_EQ(window.figures().pop_max, 5.0F);
  window.begin_frame();
  EXPECT_EQ(window.figures().samples, ErrorWindow::frames - 1);
  EXPECT_EQ(window.figures().max, 1.0F);
  EXPECT_EQ(window.figures().pop_max, 0.5F);
  EXPECT_EQ(window.figures().p99, 1.0F);
  EXPECT_EQ(window.since_start().max, 8.0F);
  EXPECT_EQ(window.since_start().pop_max, 5.0F);
}

TEST(ErrorWindow, KnowsItsNinetyNinthPercentileFromAThousandSamplesOn) {
  ErrorWindow window;
  window.begin_frame();
  for (std::uint32_t i = 1; i < ErrorFigures::samples_for_p99; ++i) window.add({.error = 1.0F, .pop = {}});
  EXPECT_FALSE(window.figures().p99_is_known());
  window.add({.error = 1.0F, .pop = {}});
  EXPECT_TRUE(window.figures().p99_is_known());
}

TEST(ErrorWindow, IsAllZeroWhereNobodyWasMeasured) {
  ErrorWindow window;
  window.begin_frame();
  EXPECT_EQ(window.figures().samples, 0U);
  EXPECT_EQ(window.figures().p99, 0.0F);
  EXPECT_EQ(window.figures().max, 0.0F);
}

}  // namespace
}  // namespace throng::anim
