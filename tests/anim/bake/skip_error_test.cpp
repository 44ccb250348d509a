#include "engine/anim/bake/skip_error.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim::skip_error_test {
namespace {

TEST(SkipErrorTest, EachFrameThatIsPosedIsExact) {
  EXPECT_EQ(SkipError{}.metres(1.0F, true), 0.0F);
  EXPECT_EQ(SkipError{}.metres(0.5F, false), 0.0F);
}

TEST(SkipErrorTest, GoesThroughWhatWasMeasuredAndBeyondAlongTheSameLaw) {
  const SkipError error{.blended = {0.001F, 0.004F, 0.016F, 0.064F}, .held = {0.01F, 0.02F, 0.04F, 0.08F}};
  EXPECT_FLOAT_EQ(error.metres(2.0F, true), 0.001F);
  EXPECT_FLOAT_EQ(error.metres(8.0F, true), 0.016F);
  EXPECT_NEAR(error.metres(3.0F, true), 0.001F * 2.25F, 1e-6F);
  EXPECT_NEAR(error.metres(32.0F, true), 0.256F, 1e-5F);
  EXPECT_NEAR(error.metres(6.0F, false), 0.03F, 1e-6F);
}

TEST(SkipErrorTest, AClipThatStandsStillHasNone) {
  Model model = synthetic_model(20, 1, 1);
  model.clips.clear();
  for (const SkipError& error : bake_character(model).skip_errors) {
    EXPECT_LT(error.metres(16.0F, true), 1e-5F);
    EXPECT_LT(error.metres(16.0F, false), 1e-5F);
  }
}

TEST(SkipErrorTest, BlendingIsOffByMoreThanTheSpanGrowsAndHoldingByMoreThanBlending) {
  const Model model = synthetic_model(62, 2, 1);
  const std::vector<SkipError> errors = bake_character(model).skip_errors;
  ASSERT_EQ(errors.size(), model.clips.size());
  for (const SkipError& error : errors) {
    EXPECT_GT(error.blended[1], 0.0F);
    const float growth = error.blended[1] / error.blended[0];
    EXPECT_GT(growth, 2.0F);
    EXPECT_LT(growth, 6.0F);
    for (std::size_t span = 0; span < error.held.size(); ++span) EXPECT_GT(error.held[span], error.blended[span]);
  }
}

}  // namespace
}  // namespace throng::anim::skip_error_test
