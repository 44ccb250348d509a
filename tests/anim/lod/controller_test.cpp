#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/anim/lod/lod_controller.h"

namespace throng::anim::controller_test {
namespace {

constexpr double millisecond = 1e6;

/// A crowd whose cost sinks as the cube root of the tolerance grows: `at_one_pixel` nanoseconds at one.
CostByTolerance crowd_costing(double at_one_pixel) {
  CostByTolerance cost{};
  for (std::size_t step = 0; step < cost.size(); ++step) {
    cost[step] = static_cast<std::uint64_t>(at_one_pixel /
                                            std::cbrt(static_cast<double>(tolerance_at(static_cast<float>(step)))));
  }
  return cost;
}

double cost_of(const CostByTolerance& cost, float tolerance) {
  const auto step = static_cast<std::size_t>(std::clamp(step_of_tolerance(tolerance), 0.0F, 71.0F));
  return static_cast<double>(cost[step]);
}

struct LodControllerTest : testing::Test {
  LodController controller;
  LodRules rules{.error_pixels = 0.0F};

  void set_budget(double nanoseconds) { rules.budget_milliseconds = nanoseconds / nanoseconds_per_millisecond; }

  void settle(const CostByTolerance& cost, double over_the_long_run = 1.0, std::optional<float> error = {}) {
    const double spent = cost_of(cost, controller.tolerance_pixels()) * over_the_long_run;
    controller.settle(rules, {.cost_by_tolerance = cost, .nanoseconds = spent, .measured_error_pixels = error});
  }
};

TEST_F(LodControllerTest, ABudgetThatIsEnoughForTheFinestBindsNothing) {
  set_budget(100 * millisecond);
  for (int frame = 0; frame < 600; ++frame) settle(crowd_costing(2 * millisecond));
  EXPECT_EQ(controller.binding(), BindingLimit::none);
  EXPECT_FLOAT_EQ(controller.tolerance_pixels(), least_tolerance_pixels);
}

TEST_F(LodControllerTest, TheBudgetIsHeldFromTheFirstFrameOn) {
  set_budget(2 * millisecond);
  const CostByTolerance cost = crowd_costing(3 * millisecond);
  EXPECT_TRUE(controller.is_new());
  controller.begin(rules, cost);
  EXPECT_FALSE(controller.is_new());
  for (int frame = 0; frame < 600; ++frame) {
    EXPECT_LE(cost_of(cost, controller.tolerance_pixels()), budget_nanoseconds(rules));
    settle(cost);
  }
  EXPECT_EQ(controller.binding(), BindingLimit::budget);
}

TEST_F(LodControllerTest, LearnsNothingFromFramesInWhichMostCameIntoView) {
  set_budget(2 * millisecond);
  const CostByTolerance cost = crowd_costing(3 * millisecond);
  settle(cost);
  const float before = controller.tolerance_pixels();
  for (int frame = 0; frame < 10; ++frame) {
    controller.settle(rules, {.cost_by_tolerance = cost, .nanoseconds = 4e6, .exempt_nanoseconds = 5e6});
  }
  EXPECT_EQ(controller.tolerance_pixels(), before);
}

TEST_F(LodControllerTest, OfAConstantCrowdTheToleranceComesToRestAndStays) {
  set_budget(2 * millisecond);
  for (int frame = 0; frame < 1200; ++frame) settle(crowd_costing(3 * millisecond), frame % 2 == 0 ? 1.05 : 0.95);
  const float settled = controller.tolerance_pixels();
  for (int frame = 0; frame < 600; ++frame) {
    settle(crowd_costing(3 * millisecond), frame % 2 == 0 ? 1.05 : 0.95);
    EXPECT_NEAR(controller.tolerance_pixels(), settled, 0.02F * settled) << frame;
  }
}

TEST_F(LodControllerTest, MostOfTheBudgetIsSpent) {
  set_budget(2 * millisecond);
  const CostByTolerance cost = crowd_costing(3 * millisecond);
  settle(crowd_costing(30 * millisecond));  // what was there before
  for (int frame = 0; frame < 1200; ++frame) settle(cost);
  EXPECT_GE(cost_of(cost, controller.tolerance_pixels()), 0.8 * budget_nanoseconds(rules));
}

TEST_F(LodControllerTest, FramesThatCostMoreThanInTheLongRunGetRoomWithinTheBudget) {
  set_budget(2 * millisecond);
  const CostByTolerance cost = crowd_costing(3 * millisecond);
  for (int frame = 0; frame < 100; ++frame) settle(cost, 1.3);
  EXPECT_LE(cost_of(cost, controller.tolerance_pixels()) * 1.3, budget_nanoseconds(rules));
}

TEST_F(LodControllerTest, WhenTheCrowdInViewChangesTheBudgetHoldsInAlmostEveryFrame) {
  set_budget(2 * millisecond);
  int over = 0;
  constexpr int frames = 1200;
  for (int frame = 0; frame < frames; ++frame) {
    const CostByTolerance cost = crowd_costing((3.0 + std::sin(frame / 100.0)) * millisecond);
    const double spent = cost_of(cost, controller.tolerance_pixels());
    over += frame > 0 && spent > budget_nanoseconds(rules) ? 1 : 0;
    controller.settle(rules, {.cost_by_tolerance = cost, .nanoseconds = spent});
  }
  EXPECT_LE(over, frames / 100);
}

TEST_F(LodControllerTest, TheToleranceComesToWhatTheMeasuredErrorAsksFor) {
  rules.error_pixels = 0.5F;
  float measured = 0.0F;
  for (int frame = 0; frame < 2000; ++frame) {
    const float shown = 0.4F * controller.tolerance_pixels();  // predictions are too careful
    measured += (shown - measured) / 30.0F;                    // over a window
    settle(crowd_costing(millisecond), 1.0, measured);
  }
  EXPECT_EQ(controller.binding(), BindingLimit::error);
  EXPECT_LE(measured, rules.error_pixels);
  EXPECT_GE(measured, 0.6F * rules.error_pixels);
}

TEST_F(LodControllerTest, WithoutAMeasuredErrorThePredictedOneIsHeld) {
  rules.error_pixels = 0.5F;
  settle(crowd_costing(millisecond));
  EXPECT_FLOAT_EQ(controller.tolerance_pixels(), 0.5F);
}

TEST_F(LodControllerTest, OfTwoLimitsThatHoldTheErrorsBinds) {
  rules.error_pixels = 1.0F;
  set_budget(4 * millisecond);
  for (int frame = 0; frame < 1200; ++frame) settle(crowd_costing(3 * millisecond));
  EXPECT_EQ(controller.binding(), BindingLimit::error);
  EXPECT_FLOAT_EQ(controller.tolerance_pixels(), 1.0F);
}

TEST_F(LodControllerTest, TheErrorsLimitGivesWayToTheBudget) {
  rules.error_pixels = 1.0F;
  set_budget(2 * millisecond);
  for (int frame = 0; frame < 300; ++frame) settle(crowd_costing(3 * millisecond));
  EXPECT_EQ(controller.binding(), BindingLimit::budget);
  EXPECT_GT(controller.tolerance_pixels(), 1.0F);
}

TEST_F(LodControllerTest, ABudgetThatNothingFitsMissesBothLimitsAtTheCoarsest) {
  rules.error_pixels = 1.0F;
  set_budget(0.1 * millisecond);
  for (int frame = 0; frame < 300; ++frame) settle(crowd_costing(3 * millisecond));
  EXPECT_EQ(controller.binding(), BindingLimit::both_miss);
  EXPECT_FLOAT_EQ(controller.tolerance_pixels(), most_tolerance_pixels);
}

}  // namespace
}  // namespace throng::anim::controller_test
