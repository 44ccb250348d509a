#include "app/lod_view.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/lod_thresholds.h"

namespace throng::app {
namespace {

TEST(IntervalThresholds, LieWhereTheRuleLengthensTheInterval) {
  Tuning tuning{.lod = LodRule::distance};
  tuning.largest_interval = 4;
  const auto thresholds = interval_thresholds(tuning);
  ASSERT_EQ(thresholds.size(), 3U);
  for (const IntervalThreshold& threshold : thresholds) {
    EXPECT_EQ(interval_at(tuning, threshold.metres + 0.01F), threshold.interval);
    EXPECT_EQ(interval_at(tuning, threshold.metres - 0.01F), threshold.interval - 1);
  }
  tuning.lod = LodRule::off;
  EXPECT_TRUE(interval_thresholds(tuning).empty());
}

TEST(ThresholdRings, AreAsFarFromTheCameraAsTheRuleSays) {
  Tuning tuning{.lod = LodRule::distance};
  tuning.full_rate_distance = 10;
  tuning.largest_interval = 2;
  const render::Camera camera{.position = {3, 7, -2}};
  SceneLines lines;
  add_threshold_rings(lines, tuning, camera, 1.0F);
  ASSERT_FALSE(lines.empty());
  for (const render::SceneLine& line : lines) {
    const glm::vec3 middle_of_agent(line.from.x, 1.0F, line.from.z);
    EXPECT_NEAR(glm::distance(middle_of_agent, camera.position), 10, 1e-3);
  }
}

TEST(ThresholdRings, DoNotReachTheGroundFromTooHighAbove) {
  Tuning tuning{.lod = LodRule::distance};
  tuning.full_rate_distance = 10;
  tuning.largest_interval = 2;
  SceneLines lines;
  add_threshold_rings(lines, tuning, {.position = {0, 50, 0}}, 1.0F);
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
}  // namespace throng::app
