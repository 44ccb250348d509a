#include "engine/anim/entity/ease_blender.h"

#include <gtest/gtest.h>

namespace throng::anim::ease_blender_test {
namespace {

void advance(EaseBlender& blender, Ticks delta) {
  blender.state.delta_time = delta;
  advance_blender(blender);
}

TEST(EaseBlender, EasesFromZeroToOneAndStays) {
  EaseBlender blender{};
  blender.total = ticks_per_second;
  float before = -1.0F;
  for (int frame = 0; frame <= 10; ++frame) {
    advance(blender, frame == 0 ? Ticks{} : ticks_per_second / 10);
    EXPECT_GT(blender.fraction, before);
    before = blender.fraction;
  }
  EXPECT_EQ(blender.fraction, 1.0F);
  advance(blender, ticks_per_second);
  EXPECT_EQ(blender.fraction, 1.0F);
  EXPECT_EQ(blender.state.delta_time, Ticks{});
}

TEST(EaseBlender, IsLevelAtBothEnds) {
  EXPECT_LT(ease(0.01F), 0.001F);
  EXPECT_GT(ease(0.99F), 0.999F);
  EXPECT_FLOAT_EQ(ease(0.5F), 0.5F);
}

TEST(EaseBlender, WaitsWhereItWasMadeForALaterTime) {
  EaseBlender blender{};
  blender.total = ticks_per_second;
  blender.elapsed = -ticks_per_second;
  advance(blender, ticks_per_second / 2);
  EXPECT_EQ(blender.fraction, 0.0F);
  advance(blender, ticks_per_second);
  EXPECT_FLOAT_EQ(blender.fraction, 0.5F);
}

TEST(EaseBlender, AHeldFractionDoesNotMove) {
  EaseBlender blender{};
  blender.total = ticks_per_second;
  blender.flags = EaseBlender::held;
  blender.fraction = 0.3F;
  advance(blender, ticks_per_second);
  EXPECT_EQ(blender.fraction, 0.3F);
}

TEST(EaseBlender, WithoutDurationIsItsTarget) {
  EaseBlender blender{};
  advance(blender, Ticks{});
  EXPECT_EQ(blender.fraction, 1.0F);
}

}  // namespace
}  // namespace throng::anim::ease_blender_test
