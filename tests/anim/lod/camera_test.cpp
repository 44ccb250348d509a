// The planes of a camera, and the agents outside of them whose shadows fall into the picture.
#include "throng/camera.h"

#include <gtest/gtest.h>

namespace throng::camera_test {
namespace {

/// Returns how far a place is inside of the nearest plane.
float depth_in(const Camera& camera, const Vec3& place) {
  float least = 1e9F;
  for (const std::array<float, 4>& plane : camera.frustum) {
    least = std::min(least, plane[0] * place.x + plane[1] * place.y + plane[2] * place.z + plane[3]);
  }
  return least;
}

/// A view of the cube from -1 to 1, straight from above.
Camera of_cube() { return camera_of({0.0F, 5.0F, 0.0F}, {0.0F, -1.0F, 0.0F}, Mat4{}, 100); }

TEST(CameraOfAMatrix, HasItsPlanesAndItsScale) {
  EXPECT_FLOAT_EQ(depth_in(of_cube(), {}), 1.0F);
  EXPECT_LT(depth_in(of_cube(), {2.0F, 0.0F, 0.0F}), 0.0F);
  EXPECT_FLOAT_EQ(of_cube().pixels_per_unit, 50.0F);
}

TEST(IncludedCasters, StandWhereTheLightComesFrom) {
  Camera camera = of_cube();
  include_casters(camera, {0.6F, 0.8F, 0.0F}, 1.8F);  // shadows fall 1.35 m towards -x
  EXPECT_GT(depth_in(camera, {2.0F, 0.0F, 0.0F}), 0.0F);
  EXPECT_LT(depth_in(camera, {-1.5F, 0.0F, 0.0F}), 0.0F) << "its shadow falls away from the picture";
  EXPECT_LT(depth_in(camera, {4.0F, 0.0F, 0.0F}), 0.0F) << "its shadow ends before the picture";
}

TEST(IncludedCasters, AreNotLookedForBeyondFaintShadows) {
  Camera camera = of_cube();
  include_casters(camera, {1.0F, 0.0F, 0.0F}, 1.8F);  // the sun is on the horizon
  EXPECT_GT(depth_in(camera, {14.0F, 0.0F, 0.0F}), 0.0F);
  EXPECT_LT(depth_in(camera, {16.0F, 0.0F, 0.0F}), 0.0F);
}

}  // namespace
}  // namespace throng::camera_test
