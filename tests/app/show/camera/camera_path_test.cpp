#include "app/show/camera/camera_path.h"

#include <gtest/gtest.h>

namespace throng::app::camera_path_test {
namespace {

const render::Camera start{.position = {30.0F, 3.0F, 40.0F}, .yaw = 0.6435F, .pitch = -0.1F};

TEST(CameraPathTest, BeginsWhereTheCameraStands) {
  for (const CameraPath path : {CameraPath::none, CameraPath::orbit, CameraPath::pan}) {
    EXPECT_EQ(along(path, start, 0.0), start);
  }
}

TEST(CameraPathTest, AnOrbitKeepsItsDistanceAndLooksAtTheMiddle) {
  for (double seconds = 1.0; seconds < 60.0; seconds += 7.0) {
    const render::Camera camera = along(CameraPath::orbit, start, seconds);
    const glm::vec3 ahead = render::forward(camera);
    EXPECT_NEAR(camera.position.x * camera.position.x + camera.position.z * camera.position.z, 2500.0F, 0.1F);
    EXPECT_NEAR(ahead.x * camera.position.z - ahead.z * camera.position.x, 0.0F, 0.01F) << "at the middle";
    EXPECT_LT(ahead.x * camera.position.x + ahead.z * camera.position.z, 0.0F);
    EXPECT_NE(camera, start);
  }
}

TEST(CameraPathTest, APanTurnsInPlaceAndComesBack) {
  const render::Camera aside = along(CameraPath::pan, start, 2.5);
  EXPECT_EQ(aside.position, start.position);
  EXPECT_NEAR(aside.yaw - start.yaw, 0.5236F, 1e-4F);
  EXPECT_NEAR(along(CameraPath::pan, start, 10.0).yaw, start.yaw, 1e-4F);
}

}  // namespace
}  // namespace throng::app::camera_path_test
