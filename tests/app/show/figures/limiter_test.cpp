#include "app/show/figures/limiter.h"

#include <vector>

#include <gtest/gtest.h>

namespace throng::app::limiter_test {
namespace {

TEST(LimiterTest, WhoeverTakesMostOfTheFrameLimitsIt) {
  EXPECT_EQ(limiting_part({.animation_ms = 4, .upload_ms = 1, .submission_ms = 1, .wait_ms = 3}), Limiter::animation);
  EXPECT_EQ(limiting_part({.animation_ms = 4, .upload_ms = 5, .submission_ms = 1, .wait_ms = 3}), Limiter::upload);
  EXPECT_EQ(limiting_part({.animation_ms = 4, .upload_ms = 1, .submission_ms = 9, .wait_ms = 3}), Limiter::submission);
  EXPECT_EQ(limiting_part({.animation_ms = 4, .upload_ms = 1, .submission_ms = 1, .wait_ms = 12}), Limiter::gpu);
}

TEST(LimiterTest, WhatIsTakenAwayNoLongerLimits) {
  FrameTimes times{.animation_ms = 4, .upload_ms = 1, .submission_ms = 1, .wait_ms = 3};
  times.animation_ms = 0;
  EXPECT_EQ(limiting_part(times), Limiter::gpu);
  times.wait_ms = 0;
  EXPECT_EQ(limiting_part(times), Limiter::upload);
}

TEST(LimiterTest, SaysItInOneSentenceWithFigures) {
  EXPECT_EQ(limit_sentence({.animation_ms = 4.125, .upload_ms = 0.25, .submission_ms = 0.625, .wait_ms = 4}, false),
            "Animation takes the longest: 4.1 of 9.0 ms a frame; upload 0.2, draw submission 0.6, GPU 4.0");
  EXPECT_EQ(limit_sentence({.animation_ms = 1, .upload_ms = 0, .submission_ms = 0, .wait_ms = 9}, false),
            "The GPU takes the longest: 9.0 of 10.0 ms a frame; animation 1.0, upload 0.0, draw submission 0.0");
  EXPECT_EQ(limit_sentence({}, false), "");
}

TEST(LimiterTest, NamesNoGpuWhereTheProcessorDraws) {
  EXPECT_EQ(
      limit_sentence({.animation_ms = 1, .upload_ms = 0, .submission_ms = 0, .wait_ms = 9}, true),
      "Filling pixels on the processor takes the longest: 9.0 of 10.0 ms a frame; animation 1.0, upload 0.0, draw "
      "submission 0.0");
  EXPECT_EQ(
      limit_sentence({.animation_ms = 9, .upload_ms = 0, .submission_ms = 0, .wait_ms = 1}, true),
      "Animation takes the longest: 9.0 of 10.0 ms a frame; upload 0.0, draw submission 0.0, filling pixels on the "
      "processor 1.0");
}

TEST(SkippingSentence, SaysThatSomethingElseTakesASlowFrame) {
  const std::vector<int> agents{100};
  EXPECT_EQ(skipping_sentence({.animation_ms = 2, .upload_ms = 1, .submission_ms = 1, .wait_ms = 96}, agents),
            "At 10.0 frames a second skipping does not pay: animation takes only 2.0 of 100.0 ms a frame, and no more "
            "could be saved.");
}

TEST(SkippingSentence, SaysThatALongFrameMayNotBeMissed) {
  const std::vector<int> agents{90, 10};
  EXPECT_EQ(
      skipping_sentence({.animation_ms = 80, .upload_ms = 0, .submission_ms = 0, .wait_ms = 0}, agents),
      "At 12.5 frames a second skipping does not pay: a pose that misses one frame is 80.0 ms old, in which limbs "
      "go far, so 95% of the poses are computed all the same.");
}

TEST(SkippingSentence, SaysNothingWhereSkippingPaysOrFramesAreShort) {
  const FrameTimes slow{.animation_ms = 80, .upload_ms = 0, .submission_ms = 0, .wait_ms = 0};
  EXPECT_EQ(skipping_sentence(slow, std::vector<int>{10, 0, 0, 90}), "");
  EXPECT_EQ(skipping_sentence(slow, {}), "");
  EXPECT_EQ(skipping_sentence({.animation_ms = 16, .upload_ms = 0, .submission_ms = 0, .wait_ms = 0}, std::vector{9}),
            "");
  EXPECT_EQ(skipping_sentence({}, std::vector{9}), "");
}

TEST(LimiterTest, OneSlowFrameDoesNotChangeTheAnswer) {
  LimiterOverFrames limiter;
  for (int i = 0; i < 60; ++i) limiter.add({.animation_ms = 5, .upload_ms = 1, .submission_ms = 1, .wait_ms = 1});
  limiter.add({.animation_ms = 5, .upload_ms = 40, .submission_ms = 1, .wait_ms = 1});
  EXPECT_TRUE(limiter.sentence(false).starts_with("Animation takes")) << limiter.sentence(false);
}

}  // namespace
}  // namespace throng::app::limiter_test
