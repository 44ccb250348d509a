#include "engine/anim/asset/morph_curves.h"

#include <gtest/gtest.h>

namespace throng::anim::morph_curves_test {
namespace {

/// Morphs 1 and 3 of 4 at second 2, 3 and 5 of a file.
Clip clip_with(Interpolation interpolation, std::vector<float> weights) {
  Clip clip;
  clip.start = 2.0;
  clip.duration = 5.0;
  clip.morph_tracks = {
      {.interpolation = interpolation, .morphs = {1, 3}, .times = {2.0F, 3.0F, 5.0F}, .weights = std::move(weights)}};
  return clip;
}

std::vector<float> weights_at(const MorphCurves& curves, double seconds, float share = 1.0F) {
  std::vector<float> weights(4, 0.0F);
  add_morph_weights(curves, to_ticks(seconds), share, weights);
  return weights;
}

void expect_near(const std::vector<float>& weights, const std::vector<float>& expected) {
  ASSERT_EQ(weights.size(), expected.size());
  for (std::size_t i = 0; i < weights.size(); ++i) EXPECT_NEAR(weights[i], expected[i], 1e-6F) << i;
}

TEST(MorphCurves, GoStraightFromKeyToKeyAndHoldOutsideOfThem) {
  const MorphCurves curves = bake_morph_curves(clip_with(Interpolation::linear, {0, 1, 0.5F, 0, 1, 1}), 2.0);
  expect_near(weights_at(curves, -1.0), {0, 0, 0, 1});
  expect_near(weights_at(curves, 0.25), {0, 0.125F, 0, 0.75F});
  expect_near(weights_at(curves, 1.0), {0, 0.5F, 0, 0});
  expect_near(weights_at(curves, 2.0), {0, 0.75F, 0, 0.5F});
  expect_near(weights_at(curves, 9.0), {0, 1, 0, 1});
}

TEST(MorphCurves, StepAtTheirKeys) {
  const MorphCurves curves = bake_morph_curves(clip_with(Interpolation::step, {0, 1, 0.5F, 0, 1, 1}), 2.0);
  expect_near(weights_at(curves, 0.99), {0, 0, 0, 1});
  expect_near(weights_at(curves, 1.0), {0, 0.5F, 0, 0});
}

TEST(MorphCurves, FollowSplinesWithTangentsASecond) {
  // The first morph goes from 0 to 1 within a second with level ends; the second stays, with a tangent out of its key.
  const MorphCurves curves = bake_morph_curves(
      clip_with(Interpolation::cubic_spline, {9, 9, 0, 0, 0, 2, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 9, 9}), 2.0);
  expect_near(weights_at(curves, 0.5), {0, 0.5F, 0, 2 * 0.125F});
  expect_near(weights_at(curves, 0.25), {0, 0.15625F, 0, 2 * 0.25F * 0.5625F});
  expect_near(weights_at(curves, 3.0), {0, 1, 0, 0});
}

TEST(MorphCurves, AddTheirShareToWhatIsThere) {
  const MorphCurves curves = bake_morph_curves(clip_with(Interpolation::linear, {0, 1, 0.5F, 0, 1, 1}), 2.0);
  std::vector<float> weights{5, 5, 5, 5};
  add_morph_weights(curves, to_ticks(1.0), 0.5F, weights);
  expect_near(weights, {5, 5.25F, 5, 5});
}

TEST(MorphCurves, LeaveOutMorphsThatStayAtRestAndKeysOfWhatStandsStill) {
  const MorphCurves still = bake_morph_curves(clip_with(Interpolation::linear, {0, 0.5F, 0, 0.5F, 0, 0.5F}), 2.0);
  ASSERT_EQ(still.size(), 1U);
  EXPECT_EQ(still[0].morphs, std::vector<std::uint32_t>{3});
  EXPECT_EQ(still[0].times.size(), 1U);
  expect_near(weights_at(still, 1.7), {0, 0, 0, 0.5F});
  EXPECT_TRUE(bake_morph_curves(clip_with(Interpolation::step, {0, 0, 0, 0, 0, 0}), 2.0).empty());
  const MorphCurves bulging = bake_morph_curves(
      clip_with(Interpolation::cubic_spline, {0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), 2.0);
  ASSERT_EQ(bulging.size(), 1U);
  EXPECT_EQ(bulging[0].times.size(), 3U) << "a tangent moves it between keys that are alike";
}

}  // namespace
}  // namespace throng::anim::morph_curves_test
