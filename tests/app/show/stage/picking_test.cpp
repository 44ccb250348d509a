#include "app/show/stage/picking.h"

#include <array>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>

namespace throng::app::picking_test {
namespace {

constexpr glm::vec2 picture{1280.0F, 720.0F};

UprightBody person(std::uint32_t agent, const glm::vec3& foot) {
  return {.agent = agent, .foot = foot, .radius = 0.3F, .height = 1.8F};
}

/// Where a camera shows a point of the world.
glm::vec2 pixel_of(const render::Camera& camera, const glm::vec3& point) {
  const render::CameraView view = render::view_of(camera, picture.x / picture.y);
  const glm::vec4 clip = view.projection * view.view * glm::vec4(point, 1.0F);
  return {(clip.x / clip.w * 0.5F + 0.5F) * picture.x, (0.5F - clip.y / clip.w * 0.5F) * picture.y};
}

TEST(Picking, ARayGoesThroughThePointThatItsPixelShows) {
  const render::Camera camera{.position = {3.0F, 2.0F, 7.0F}, .yaw = 0.6F, .pitch = -0.3F};
  for (const glm::vec3 point : {glm::vec3(0.0F, 1.0F, 0.0F), glm::vec3(-2.0F, 0.0F, -5.0F)}) {
    const PickRay ray = ray_through(camera, pixel_of(camera, point), picture);
    EXPECT_GT(glm::dot(ray.direction, glm::normalize(point - camera.position)), 0.999999F);
    EXPECT_EQ(ray.origin, camera.position);
  }
}

TEST(Picking, TheNearerOfTwoInARowIsHit) {
  const std::array bodies = {person(4, {0.0F, 0.0F, -9.0F}), person(7, {0.0F, 0.0F, -5.0F})};
  const auto hit = pick({.origin = {0.0F, 1.0F, 0.0F}, .direction = {0.0F, 0.0F, -1.0F}}, bodies);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->agent, 7U);
  EXPECT_FLOAT_EQ(hit->distance, 4.7F);
}

TEST(Picking, BesideAboveAndBehindNobodyIsHit) {
  const std::array bodies = {person(0, {0.0F, 0.0F, -5.0F})};
  const glm::vec3 ahead(0.0F, 0.0F, -1.0F);
  EXPECT_TRUE(pick({{0.29F, 1.0F, 0.0F}, ahead}, bodies));
  EXPECT_FALSE(pick({{0.31F, 1.0F, 0.0F}, ahead}, bodies)) << "beside";
  EXPECT_TRUE(pick({{0.0F, 1.79F, 0.0F}, ahead}, bodies));
  EXPECT_FALSE(pick({{0.0F, 1.81F, 0.0F}, ahead}, bodies)) << "above";
  EXPECT_FALSE(pick({{0.0F, -0.01F, 0.0F}, ahead}, bodies)) << "below";
  EXPECT_FALSE(pick({{0.0F, 1.0F, 0.0F}, -ahead}, bodies)) << "behind";
  EXPECT_FALSE(pick({{0.0F, 1.0F, 0.0F}, ahead}, {})) << "nobody there";
}

TEST(Picking, SeenFromAboveTheHeadIsHit) {
  const std::array bodies = {person(3, {2.0F, 0.5F, 2.0F})};
  const glm::vec3 down(0.0F, -1.0F, 0.0F);
  const auto hit = pick({{2.2F, 10.0F, 2.1F}, down}, bodies);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 10.0F - 2.3F, 1e-5F);
  EXPECT_FALSE(pick({{2.4F, 10.0F, 2.0F}, down}, bodies));
}

TEST(Picking, SlantingRaysMeetSidesAndCaps) {
  const std::array bodies = {person(0, {0.0F, 0.0F, 0.0F})};
  const auto towards = [&](const glm::vec3& from, const glm::vec3& to) {
    return pick({from, glm::normalize(to - from)}, bodies).has_value();
  };
  EXPECT_TRUE(towards({3.0F, 3.0F, 0.0F}, {0.0F, 1.7F, 0.0F}));
  EXPECT_FALSE(towards({3.0F, 3.0F, 0.0F}, {0.0F, 2.1F, 0.0F})) << "over the head";
  EXPECT_FALSE(towards({3.0F, 3.0F, 0.0F}, {0.6F, 0.0F, 0.0F})) << "in front of the feet";
}

TEST(Picking, WhoeverTheCameraStandsInIsPassedOver) {
  const std::array bodies = {person(0, {0.0F, 0.0F, 0.0F}), person(1, {0.0F, 0.0F, -3.0F})};
  const auto hit = pick({{0.0F, 1.6F, 0.0F}, {0.0F, 0.0F, -1.0F}}, bodies);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->agent, 1U);
}

}  // namespace
}  // namespace throng::app::picking_test
