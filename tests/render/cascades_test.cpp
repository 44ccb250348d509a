#include "engine/render/light/cascades.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "throng/render/camera.h"

namespace throng::render::cascades_test {
namespace {

constexpr int side = 1024;
constexpr float aspect = 16.0F / 9.0F;
constexpr DepthRange depths{1.0F, 120.0F};
const glm::vec3 to_sun = glm::normalize(glm::vec3(0.5F, 0.7F, 0.4F));

std::array<Cascade, cascade_count> planned(const Camera& camera) {
  return plan_cascades(view_of(camera, aspect), sun_axes(to_sun), depths, side);
}

glm::vec3 place_in(const Cascade& cascade, const glm::vec3& point) {
  return glm::vec3(cascade.to_clip * glm::vec4(point, 1.0F));
}

/// Returns points all over the part of the frustum that lies between two depths.
std::vector<glm::vec3> points_between(const Camera& camera, float from, float to) {
  const glm::mat4 to_world = glm::inverse(view_of(camera, aspect).view);
  const float up = std::tan(camera.vertical_view / 2.0F);
  std::vector<glm::vec3> points;
  for (const float depth : {from, (from + to) / 2.0F, to}) {
    for (const float x : {-1.0F, 0.0F, 1.0F}) {
      for (const float y : {-1.0F, 0.0F, 1.0F}) {
        points.emplace_back(to_world * glm::vec4(x * up * aspect * depth, y * up * depth, -depth, 1.0F));
      }
    }
  }
  return points;
}

TEST(Cascades, HoldEverythingThatIsSeenAtTheirDepths) {
  const Camera camera{.position = {3.0F, 1.7F, -8.0F}, .yaw = 0.7F, .pitch = -0.2F};
  float from = depths.nearest;
  for (const Cascade& cascade : planned(camera)) {
    for (const glm::vec3& point : points_between(camera, from, cascade.reach)) {
      const glm::vec3 place = place_in(cascade, point);
      EXPECT_LE(std::max(std::abs(place.x), std::abs(place.y)), 1.0F);
      EXPECT_TRUE(place.z > 0.0F && place.z < 1.0F) << place.z;
    }
    from = cascade.reach;
  }
  EXPECT_FLOAT_EQ(from, depths.farthest);
}

TEST(Cascades, AreFinerNearTheCamera) {
  const auto cascades = planned({});
  for (std::size_t i = 1; i < cascades.size(); ++i) EXPECT_GT(cascades.at(i).texel, 1.4F * cascades.at(i - 1).texel);
}

TEST(Cascades, MoveInWholeTexelsAndKeepTheirSizeWhicheverWayTheCameraLooks) {
  Camera camera{.position = {0.3F, 1.7F, 0.1F}};
  const auto before = planned(camera);
  for (int step = 0; step < 20; ++step) {
    camera.position += glm::vec3(0.013F, 0.0F, 0.029F);
    camera.yaw += 0.11F;
    const auto after = planned(camera);
    for (std::size_t i = 0; i < after.size(); ++i) {
      EXPECT_FLOAT_EQ(after.at(i).texel, before.at(i).texel);
      // Where a point of the world lies within its texel must not change.
      const glm::vec3 moved = (place_in(after.at(i), {1, 0, 2}) - place_in(before.at(i), {1, 0, 2})) * (side / 2.0F);
      EXPECT_NEAR(moved.x, std::round(moved.x), 0.03F) << i;
      EXPECT_NEAR(moved.y, std::round(moved.y), 0.03F) << i;
    }
  }
}

TEST(Cascades, PutTheSunAtDepthZero) {
  const Cascade cascade = planned({}).front();
  EXPECT_LT(place_in(cascade, cascade.centre + to_sun).z, place_in(cascade, cascade.centre - to_sun).z);
}

TEST(Cascades, TakeCastersTowardsTheSunAndNoneBehind) {
  const SunAxes axes = sun_axes(to_sun);
  const auto cascades = planned({});
  const Cascade& cascade = cascades.front();
  const CastLimits limits = cast_limits(cascades, axes, {true, true, true, true});
  const auto casts = [&](const glm::vec3& from_middle) {
    return may_cast(limits, axes.along(cascade.centre + from_middle), 1.0F)[0] != 0;
  };
  const float far = 50.0F * cascade.radius;
  EXPECT_TRUE(casts({}));
  EXPECT_TRUE(casts(far * to_sun));
  EXPECT_FALSE(casts(-far * to_sun));
  EXPECT_FALSE(casts(far * axes.x));
  EXPECT_TRUE(casts((cascade.radius + 0.9F) * axes.x));
}

TEST(SunAxes, StandOnEachOtherEvenWhereTheSunIsOverhead) {
  for (const glm::vec3& sun : {to_sun, glm::vec3(0, 1, 0), glm::normalize(glm::vec3(1, 0.01F, 0))}) {
    const SunAxes axes = sun_axes(sun);
    EXPECT_NEAR(glm::length(axes.x), 1.0F, 1e-5F);
    EXPECT_NEAR(glm::dot(axes.x, axes.z), 0.0F, 1e-5F);
    EXPECT_LT(glm::distance(glm::cross(axes.x, axes.y), axes.z), 1e-5F);
  }
}

TEST(Depths, SeldomChangeAsTheCameraMoves) {
  std::vector<InstanceRecord> instances(40);
  for (std::size_t i = 0; i < instances.size(); ++i) instances[i].position[2] = -2.0F * static_cast<float>(i);
  CrowdFrame frame;
  frame.instances = instances;
  Camera camera{.position = {0.0F, 1.7F, 8.0F}};
  int changes = 0;
  DepthRange before{};
  for (int step = 0; step < 100; ++step) {
    frame.camera = view_of(camera, aspect);
    const DepthRange depths_now = depths_of(frame);
    if (depths_now.nearest != before.nearest || depths_now.farthest != before.farthest) ++changes;
    before = depths_now;
    EXPECT_LE(depths_now.nearest, std::max(camera.position.z - 2.9F, 0.25F));
    EXPECT_GE(depths_now.farthest, camera.position.z + 80.0F);
    camera.position.z += 0.05F;
  }
  EXPECT_LE(changes, 5);
}

}  // namespace
}  // namespace throng::render::cascades_test
