#include "engine/anim/entity/fading_weight.h"

#include <cmath>

#include <gtest/gtest.h>

namespace throng::anim::fading_weight_test {
namespace {

TEST(FadingWeight, IsNothingToBeginWith) { EXPECT_EQ(value(FadingWeight{}), 0.0F); }

TEST(FadingWeight, IsThereAtOnceWithoutAFade) {
  FadingWeight weight{};
  fade_to(weight, 0.3F, 0.0F, 0.0F);
  EXPECT_EQ(value(weight), 0.3F);
}

TEST(FadingWeight, EasesOverItsFadeAndStaysThere) {
  FadingWeight weight{};
  fade_to(weight, 1.0F, 2.0F, 0.0F);
  EXPECT_EQ(value(weight), 0.0F);
  advance_weight(weight, 1.0F);
  EXPECT_FLOAT_EQ(value(weight), 0.5F);
  advance_weight(weight, 5.0F);
  EXPECT_EQ(value(weight), 1.0F);
}

TEST(FadingWeight, CanBeWoundBackIntoAFadeThatIsOver) {
  FadingWeight weight{};
  fade_to(weight, 1.0F, 2.0F, 0.0F);
  advance_weight(weight, 2.5F);
  advance_weight(weight, -1.5F);
  EXPECT_FLOAT_EQ(value(weight), 0.5F);
}

TEST(FadingWeight, TurnsRoundWithoutAJump) {
  FadingWeight weight{};
  fade_to(weight, 1.0F, 1.0F, 0.0F);
  advance_weight(weight, 0.3F);
  const float before = value(weight);
  fade_to(weight, 0.0F, 1.0F, 0.0F);
  EXPECT_EQ(value(weight), before);
  advance_weight(weight, 1.0F);
  EXPECT_EQ(value(weight), 0.0F);
}

TEST(FadingWeight, BeginsWhenItWasAskedForWhereverTheEntityStands) {
  FadingWeight behind{};
  fade_to(behind, 1.0F, 1.0F, -0.25F);
  EXPECT_EQ(value(behind), 0.0F);
  advance_weight(behind, 0.75F);
  EXPECT_FLOAT_EQ(value(behind), 0.5F);
}

TEST(FadingWeight, ThatIsSetAtOnceCanBeWoundBackToThatMomentAndBeyond) {
  FadingWeight ahead{};
  fade_to(ahead, 1.0F, 0.0F, 0.25F);
  advance_weight(ahead, -0.25F);
  EXPECT_EQ(value(ahead), 1.0F) << "when it was asked for";
  advance_weight(ahead, -0.25F);
  EXPECT_EQ(value(ahead), 0.0F) << "before that";
}

}  // namespace
}  // namespace throng::anim::fading_weight_test
