#include "throng/render/camera.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace throng::render::camera_test {
namespace {

constexpr float quarter_turn = 1.57079632679F;

glm::vec3 projected(const CameraView& view, const glm::vec3& point) {
  const glm::vec4 clip = view.projection * view.view * glm::vec4(point, 1.0F);
  return glm::vec3(clip) / clip.w;
}

bool sees(const CameraView& view, const glm::vec3& centre, float radius) {
  return std::ranges::none_of(frustum_planes(view), [&](const glm::vec4& plane) {
    return glm::dot(glm::vec3(plane), centre) + plane.w < -radius;
  });
}

void expect_near(const glm::vec3& actual, const glm::vec3& expected, float tolerance = 1e-5F) {
  EXPECT_LT(glm::distance(actual, expected), tolerance) << actual.x << ' ' << actual.y << ' ' << actual.z;
}

Camera at_origin() {
  Camera camera;
  camera.position = {0.0F, 0.0F, 0.0F};
  return camera;
}

TEST(Camera, LooksAlongMinusZTurnsLeftAndUp) {
  Camera camera = at_origin();
  expect_near(forward(camera), {0.0F, 0.0F, -1.0F});
  expect_near(right(camera), {1.0F, 0.0F, 0.0F});
  camera.yaw = quarter_turn;
  expect_near(forward(camera), {-1.0F, 0.0F, 0.0F});
  camera = at_origin();
  camera.pitch = quarter_turn / 2;
  EXPECT_GT(forward(camera).y, 0.7F);
}

TEST(CameraView, PutsWhatIsAheadInTheMiddleAndRightToTheRight) {
  const CameraView view = view_of(at_origin(), 16.0F / 9.0F);
  expect_near(projected(view, {0.0F, 0.0F, -10.0F}) * glm::vec3(1, 1, 0), {0.0F, 0.0F, 0.0F});
  EXPECT_GT(projected(view, {1.0F, 0.0F, -10.0F}).x, 0.0F);
  EXPECT_GT(projected(view, {0.0F, 1.0F, -10.0F}).y, 0.0F);
}

TEST(CameraView, ReversesDepth) {
  const CameraView view = view_of(at_origin(), 1.0F);
  EXPECT_NEAR(projected(view, {0.0F, 0.0F, -Camera::near_distance}).z, 1.0F, 1e-6F);
  EXPECT_NEAR(projected(view, {0.0F, 0.0F, -Camera::far_distance}).z, 0.0F, 1e-6F);
  EXPECT_GT(projected(view, {0.0F, 0.0F, -5.0F}).z, projected(view, {0.0F, 0.0F, -6.0F}).z);
}

TEST(Frustum, KeepsWhatTouchesThePictureAndDropsTheRest) {
  Camera camera = at_origin();
  camera.vertical_view = quarter_turn;
  const CameraView view = view_of(camera, 1.0F);
  EXPECT_TRUE(sees(view, {0.0F, 0.0F, -10.0F}, 1.0F));
  EXPECT_FALSE(sees(view, {0.0F, 0.0F, 10.0F}, 1.0F));
  // At 45 degrees a sphere reaches into the picture from up to radius * sqrt(2) beside its edge.
  EXPECT_TRUE(sees(view, {11.3F, 0.0F, -10.0F}, 1.0F));
  EXPECT_FALSE(sees(view, {11.5F, 0.0F, -10.0F}, 1.0F));
  EXPECT_TRUE(sees(view, {0.0F, -11.3F, -10.0F}, 1.0F));
  EXPECT_FALSE(sees(view, {0.0F, -11.5F, -10.0F}, 1.0F));
  EXPECT_FALSE(sees(view, {0.0F, 0.0F, -Camera::far_distance - 2.0F}, 1.0F));
}

TEST(PixelsTall, IsWhatTheProjectionGives) {
  const Camera camera = at_origin();
  const CameraView view = view_of(camera, 1.5F);
  const float top = projected(view, {0.0F, 0.9F, -12.0F}).y;
  const float bottom = projected(view, {0.0F, -0.9F, -12.0F}).y;
  EXPECT_NEAR(pixels_tall(camera, 720.0F, 1.8F, 12.0F), (top - bottom) * 360.0F, 1e-2F);
}

TEST(FlyCamera, MovesWhereItLooksBySpeedAndTime) {
  FlyInput input;
  input.move = {0.0F, 0.0F, 1.0F};
  input.speed = 4.0F;
  const Camera moved = fly(at_origin(), input, 0.5F);
  expect_near(moved.position, {0.0F, 0.0F, -2.0F});
}

TEST(FlyCamera, RisesStraightUpWhereverItLooks) {
  Camera camera = at_origin();
  camera.pitch = -1.0F;
  FlyInput input;
  input.move = {0.0F, 1.0F, 0.0F};
  input.speed = 1.0F;
  expect_near(fly(camera, input, 2.0F).position, {0.0F, 2.0F, 0.0F});
}

TEST(FlyCamera, NeverTurnsOverAndWrapsItsYaw) {
  FlyInput input;
  input.turn_up = 10.0F;
  input.turn_left = 100.0F;
  const Camera turned = fly(at_origin(), input, 0.0F);
  EXPECT_FLOAT_EQ(turned.pitch, Camera::pitch_limit);
  EXPECT_LE(std::abs(turned.yaw), 3.1416F);
}

TEST(Orbit, KeepsThePointInItsPlaceInThePicture) {
  Camera camera = at_origin();
  camera.position = {3.0F, 2.0F, 7.0F};
  camera.yaw = 0.4F;
  camera.pitch = -0.2F;
  const glm::vec3 point{1.0F, 0.5F, -2.0F};
  const Camera turned = orbit(camera, point, 0.9F, -0.3F);
  EXPECT_NEAR(glm::distance(turned.position, point), glm::distance(camera.position, point), 1e-4F);
  EXPECT_NEAR(turned.yaw, 1.3F, 1e-6F);
  EXPECT_NEAR(turned.pitch, -0.5F, 1e-6F);
  expect_near(projected(view_of(turned, 1.5F), point), projected(view_of(camera, 1.5F), point), 1e-4F);
}

TEST(Orbit, NeverTurnsOver) {
  const Camera turned = orbit(at_origin(), {0.0F, 0.0F, -5.0F}, 0.0F, -10.0F);
  EXPECT_FLOAT_EQ(turned.pitch, -Camera::pitch_limit);
  EXPECT_NEAR(glm::length(turned.position - glm::vec3(0.0F, 0.0F, -5.0F)), 5.0F, 1e-4F);
  EXPECT_GT(turned.position.y, 4.9F);
}

}  // namespace
}  // namespace throng::render::camera_test
