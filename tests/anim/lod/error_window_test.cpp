#include "engine/anim/lod/error_window.h"

#include <gtest/gtest.h>

namespace throng::anim::error_window_test {
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

TEST(ErrorCounts, SayBetweenWhichErrorsAPercentileLies) {
  ErrorCounts counts;
  EXPECT_EQ(counts.interval(0.99).low, 0.0F);
  EXPECT_FALSE(counts.interval(0.99).high) << "no sample says anything";
  for (int i = 1; i <= 300; ++i) counts.add(ErrorCounts::step_of(static_cast<float>(i) * 0.01F));
  EXPECT_GT(counts.interval(0.99).low, 2.8F);
  EXPECT_FALSE(counts.interval(0.99).high) << "a hundredth of the agents may be off by any length";
  for (int i = 301; i <= 1000; ++i) counts.add(ErrorCounts::step_of(static_cast<float>(i) * 0.01F));
  EXPECT_NEAR(counts.interval(0.99).low, 9.83F, 0.03F * 9.83F);
  EXPECT_NEAR(*counts.interval(0.99).high, 9.97F, 0.03F * 9.97F);
  EXPECT_LE(counts.interval(0.5).low, counts.percentile(0.5));
  EXPECT_GE(*counts.interval(0.5).high, counts.percentile(0.5));
}

void pass_frame(ErrorWindow& window, std::uint32_t samples, const ErrorSample& sample) {
  window.begin_frame();
  for (std::uint32_t i = 0; i < samples; ++i) window.add(sample);
}

TEST(ErrorWindow, HoldsSixtyFramesAndForgetsTheOldest) {
  constexpr std::uint32_t samples = 20;
  ErrorWindow window;
  pass_frame(window, samples, {.error = 8.0F, .pop = 5.0F});
  for (std::size_t frame = 1; frame < ErrorWindow::frames; ++frame) {
    pass_frame(window, samples, {.error = 1.0F, .pop = 0.5F});
  }
  EXPECT_EQ(window.figures().samples, samples * ErrorWindow::frames);
  EXPECT_EQ(window.figures().max, 8.0F);
  EXPECT_EQ(window.figures().pop_max, 5.0F);
  EXPECT_GT(window.figures().p99, 1.1F);
  pass_frame(window, samples, {.error = 1.0F, .pop = 0.5F});
  EXPECT_EQ(window.figures().samples, samples * ErrorWindow::frames);
  EXPECT_EQ(window.figures().max, 1.0F);
  EXPECT_EQ(window.figures().pop_max, 0.5F);
  EXPECT_NEAR(window.figures().p99, 1.0F, 0.04F);
  EXPECT_EQ(window.since_start().max, 8.0F);
  EXPECT_EQ(window.since_start().pop_max, 5.0F);
  EXPECT_EQ(window.since_start().samples, samples * (ErrorWindow::frames + 1));
}

TEST(ErrorWindow, LooksFurtherBackWhereSixtyFramesHaveTooFewSamples) {
  ErrorWindow window;
  for (std::size_t frame = 0; frame < 3 * ErrorWindow::frames; ++frame)
    pass_frame(window, 2, {.error = 1.0F, .pop = {}});
  EXPECT_EQ(window.figures().samples, 6 * ErrorWindow::frames);
  for (std::size_t frame = 0; frame < ErrorWindow::most_frames; ++frame)
    pass_frame(window, 2, {.error = 0.1F, .pop = {}});
  EXPECT_GE(window.figures().samples, ErrorFigures::samples_for_p99);
  EXPECT_LE(window.figures().samples, ErrorFigures::samples_for_p99 + 2) << "and no further than it has to";
  EXPECT_LT(window.figures().p99, 0.11F);
}

TEST(ErrorWindow, NeverLooksBackFurtherThanSixHundredFrames) {
  ErrorWindow window;
  pass_frame(window, 1, {.error = 9.0F, .pop = {}});
  for (std::size_t frame = 0; frame < ErrorWindow::most_frames; ++frame) window.begin_frame();
  EXPECT_EQ(window.figures().samples, 0U);
}

TEST(ErrorWindow, KnowsItsNinetyNinthPercentileFromAThousandSamplesOn) {
  ErrorWindow window;
  window.begin_frame();
  for (std::uint32_t i = 1; i < ErrorFigures::samples_for_p99; ++i) window.add({.error = 1.0F, .pop = {}});
  EXPECT_FALSE(window.figures().p99_is_known());
  window.add({.error = 1.0F, .pop = {}});
  EXPECT_TRUE(window.figures().p99_is_known());
}

TEST(ErrorWindow, TellsTheLargestPopOfTheNewestFrame) {
  ErrorWindow window;
  pass_frame(window, 2, {.error = 1.0F, .pop = 3.0F});
  pass_frame(window, 2, {.error = 1.0F, .pop = 0.5F});
  EXPECT_EQ(window.newest_pop(), 0.5F);
  EXPECT_EQ(window.figures().pop_max, 3.0F);
}

TEST(ErrorWindow, BegunAnewKnowsTheOldOnesOnlySinceTheStart) {
  ErrorWindow window;
  window.begin_frame();
  window.add({.error = 8.0F, .pop = {}});
  window.begin_anew();
  EXPECT_EQ(window.figures().samples, 0U);
  EXPECT_EQ(window.figures().max, 0.0F);
  window.begin_frame();
  window.add({.error = 1.0F, .pop = {}});
  EXPECT_EQ(window.figures().max, 1.0F);
  EXPECT_EQ(window.since_start().max, 8.0F);
  EXPECT_EQ(window.since_start().samples, 2U);
}

TEST(ErrorWindow, IsAllZeroWhereNobodyWasMeasured) {
  ErrorWindow window;
  window.begin_frame();
  EXPECT_EQ(window.figures().samples, 0U);
  EXPECT_EQ(window.figures().p99, 0.0F);
  EXPECT_EQ(window.figures().max, 0.0F);
}

}  // namespace
}  // namespace throng::anim::error_window_test
