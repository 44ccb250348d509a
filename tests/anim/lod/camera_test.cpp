// The planes of a camera, and the agents outside of them whose shadows fall into the picture.
#include "throng/camera.h"

#include <algorithm>
#include <array>
#include <cmath>

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

/// The depths of a perspective with planes at half a metre and 50 m: a + b / distance.
struct Depths {
  const char* name;
  float a, b;
  bool has_far_plane = true;
  float near_plane = 0.5F;
};

/// Looks along +x from (3, 2, 1), with a right angle from side to side and from top to bottom.
Camera looking_ahead(const Depths& depths) {
  constexpr float x = 3.0F, y = 2.0F, z = 1.0F;
  const float clip_from_world[16] = {0, 0, depths.a, 1, 0, 1, 0, 0, 1, 0, 0, 0, -z, -y, depths.b - depths.a * x, -x};
  return camera_of({x, y, z}, {1.0F, 0.0F, 0.0F}, clip_from_world, 100);
}

TEST(CameraOfAMatrix, HasTheDepthsThatTheMatrixTells) {
  constexpr float n = 0.5F, f = 50.0F, range = f - n;
  for (const Depths& depths :
       {Depths{"-1 to 1", (f + n) / range, -2 * f * n / range}, Depths{"1 to -1", -(f + n) / range, 2 * f * n / range},
        Depths{"0 to 1", f / range, -f * n / range, true, 0.5F * n}, Depths{"1 to 0", -n / range, f * n / range},
        Depths{"-1 to 1, infinite", 1.0F, -2 * n, false},
        Depths{"-1 to 1, infinite, rounded", std::nextafter(1.0F, 2.0F), -2 * n, false},
        Depths{"1 to -1, infinite", -1.0F, 2 * n, false}, Depths{"0 to 1, infinite", 1.0F, -n, false, 0.5F * n},
        Depths{"1 to 0, infinite", 0.0F, n, false}}) {
    const Camera camera = looking_ahead(depths);
    const auto is_in = [&](float distance) { return depth_in(camera, {3.0F + distance, 2.0F, 1.0F}) >= 0.0F; };
    EXPECT_TRUE(is_in(1.05F * depths.near_plane)) << depths.name;
    EXPECT_FALSE(is_in(0.95F * depths.near_plane)) << depths.name;
    EXPECT_TRUE(is_in(49.9F)) << depths.name;
    EXPECT_EQ(is_in(50.1F), !depths.has_far_plane) << depths.name;
    EXPECT_EQ(is_in(1e6F), !depths.has_far_plane) << depths.name;
    EXPECT_EQ(camera.frustum[5] == (std::array<float, 4>{}), !depths.has_far_plane) << depths.name;
    EXPECT_FALSE(is_in(-1.0F)) << depths.name;
  }
}

TEST(CameraOfAMatrix, WithoutPerspectiveHoldsWhatItShows) {
  Mat4 zero_to_one;  // shows z from 0 to 10, where it looks along +z
  zero_to_one.columns[2][2] = 0.1F;
  const Camera camera = camera_of({}, {0.0F, 0.0F, 1.0F}, zero_to_one, 100);
  EXPECT_GE(depth_in(camera, {0.0F, 0.0F, 0.1F}), 0.0F);
  EXPECT_GE(depth_in(camera, {0.0F, 0.0F, 9.9F}), 0.0F);
  EXPECT_LT(depth_in(camera, {0.0F, 0.0F, 10.1F}), 0.0F);
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
