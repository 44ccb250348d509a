// A number over the time of a clip.

#include "engine/anim/asset/user_curves.h"

#include <gtest/gtest.h>

namespace throng::anim::user_curves_test {
namespace {

UserCurve glow() {
  return bake_curve({.name = "glow", .times = {1.0F, 1.5F, 2.5F}, .values = {0.0F, 1.0F, -1.0F}}, 1.0, 3);
}

TEST(UserCurve, IsLinearBetweenItsKeys) {
  EXPECT_EQ(value_at(glow(), to_ticks(0.25)), 0.5F);
  EXPECT_EQ(value_at(glow(), to_ticks(0.5)), 1.0F);
  EXPECT_EQ(value_at(glow(), to_ticks(1.0)), 0.0F);
}

TEST(UserCurve, HoldsItsFirstAndLastValue) {
  EXPECT_EQ(value_at(glow(), to_ticks(-1.0)), 0.0F);
  EXPECT_EQ(value_at(glow(), to_ticks(9.0)), -1.0F);
  EXPECT_EQ(value_at(bake_curve({.name = "one", .times = {1.0F}, .values = {7.0F}}, 0.0, 0), Ticks{}), 7.0F);
}

TEST(UserCurve, IsFoundByItsName) {
  const UserCurves curves{glow()};
  EXPECT_EQ(find_curve(curves, 3), &curves.front());
  EXPECT_EQ(find_curve(curves, 0), nullptr);
}

}  // namespace
}  // namespace throng::anim::user_curves_test
