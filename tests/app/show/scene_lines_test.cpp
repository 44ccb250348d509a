#include "app/show/scene_lines.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace throng::app::scene_lines_test {
namespace {

TEST(IntervalThresholds, LieWhereTheRuleByDistanceHasThem) {
  Tuning tuning{.lod = {.rule = LodRule::distance, .full_rate_distance = 10, .interval_growth = 5, .smooth = true}};
  tuning.lod.largest_interval = 4;
  const auto thresholds = interval_thresholds(tuning);
  ASSERT_EQ(thresholds.size(), 3U);
  EXPECT_EQ(interval_at(thresholds, 9.9F), 1);
  EXPECT_EQ(interval_at(thresholds, 10), 2);
  EXPECT_EQ(interval_at(thresholds, 14.9F), 2);
  EXPECT_EQ(interval_at(thresholds, 15), 3);
  EXPECT_EQ(interval_at(thresholds, 1000), 4);
}

/// A person who walks, whose levels are off by a millimetre, a centimetre and a decimetre.
anim::MotionLod walk(bool smooth = true) {
  const anim::LodCharacter person{.level_error_metres = {0.0F, 0.001F, 0.01F, 0.1F},
                                  .update_nanoseconds = {1600, 1200, 800, 400}};
  return {person, {}, {.rule = LodRule::budget, .smooth = smooth}, 1.0F / 60.0F};
}

TEST(IntervalThresholds, LieWhereTheRuleByPixelsChangesItsChoice) {
  const anim::MotionLod motion = walk();
  const ErrorView view{.tolerance_pixels = 0.5F, .pixels_per_unit = 800};
  const auto thresholds = interval_thresholds(motion, view);
  ASSERT_GE(thresholds.size(), 3U);
  for (float metres = 0.5F; metres < 180; metres *= 1.01F) {
    const float allowed = metres * view.tolerance_pixels / view.pixels_per_unit;
    const bool at_a_step = motion.choose(allowed * 1.01F) != motion.choose(allowed * 0.99F);
    if (at_a_step) continue;
    EXPECT_EQ(interval_at(thresholds, metres), motion.choose(allowed).interval) << metres << " m";
  }
}

TEST(IntervalThresholds, MoveOutWithAFinerToleranceAndWithoutBlending) {
  const auto first = [](const anim::MotionLod& motion, float pixels) {
    return interval_thresholds(motion, {.tolerance_pixels = pixels, .pixels_per_unit = 800}).front().metres;
  };
  EXPECT_NEAR(first(walk(), 0.5F), 2 * first(walk(), 1), 1e-3);
  EXPECT_GT(first(walk(false), 1), first(walk(), 1)) << "a held pose is farther off";
}

TEST(ThresholdRings, AreAsFarFromTheCameraAsTheThresholds) {
  const std::vector<IntervalThreshold> thresholds{{10, 2}};
  const render::Camera camera{.position = {3, 7, -2}};
  SceneLines lines;
  add_threshold_rings(lines, thresholds, camera, 1.0F);
  ASSERT_FALSE(lines.empty());
  for (const render::SceneLine& line : lines) {
    const glm::vec3 middle_of_agent(line.from.x, 1.0F, line.from.z);
    EXPECT_NEAR(glm::distance(middle_of_agent, camera.position), 10, 1e-3);
  }
}

TEST(ThresholdRings, DoNotReachTheGroundFromTooHighAbove) {
  const std::vector<IntervalThreshold> thresholds{{10, 2}};
  SceneLines lines;
  add_threshold_rings(lines, thresholds, {.position = {0, 50, 0}}, 1.0F);
  EXPECT_TRUE(lines.empty());
}

TEST(FrustumLines, StayAboveTheGroundAndEndWhereTheCameraSeesNoFarther) {
  SceneLines lines;
  const render::Camera camera{.position = {0, 2, 0}, .pitch = -0.3F};
  add_frustum(lines, camera, 16.0F / 9.0F, 40);
  const auto lowest = [](const render::SceneLine& line) { return std::min(line.from.y, line.to.y); };
  EXPECT_GT(lowest(*std::ranges::min_element(lines, {}, lowest)), 0);
  float deepest = 0;
  for (const render::SceneLine& line : lines) {
    for (const glm::vec3& end : {line.from, line.to}) {
      deepest = std::max(deepest, glm::dot(end - camera.position, render::forward(camera)));
    }
  }
  EXPECT_NEAR(deepest, 40, 1e-2);
}

TEST(FrustumLines, AreDrawnOnTheGroundThatTheCameraSees) {
  SceneLines lines;
  add_frustum(lines, {.position = {0, 5, 0}, .pitch = -0.5F}, 1.5F, 30);
  const auto on_ground = [](const render::SceneLine& line) { return line.from.y < 0.1F && line.to.y < 0.1F; };
  EXPECT_GE(std::ranges::count_if(lines, on_ground), 3);
  SceneLines in_the_sky;
  add_frustum(in_the_sky, {.position = {0, 5, 0}, .pitch = 1.2F}, 1.5F, 30);
  EXPECT_EQ(std::ranges::count_if(in_the_sky, on_ground), 0);
}

}  // namespace
}  // namespace throng::app::scene_lines_test
