#include "app/show/camera/fly_camera.h"

#include <gtest/gtest.h>

namespace throng::app::fly_camera_test {
namespace {

InputFrame holding(std::initializer_list<Key> keys) {
  InputFrame input;
  for (const Key key : keys) input.keys_down.set(static_cast<std::size_t>(key));
  return input;
}

InputFrame looking(float moved_x, float moved_y) {
  InputFrame input;
  input.buttons_down.set(static_cast<std::size_t>(MouseButton::right));
  input.moved_x = moved_x;
  input.moved_y = moved_y;
  return input;
}

TEST(FlyCamera, WFliesWhereItLooksAndDToTheRight) {
  FlyCamera camera({});
  camera.update(holding({Key::w, Key::d}), {}, 1);
  EXPECT_LT(camera.place().z, -1);
  EXPECT_GT(camera.place().x, 1);
}

TEST(FlyCamera, EAndQGoUpAndDown) {
  FlyCamera camera({});
  camera.update(holding({Key::e}), {}, 1);
  EXPECT_GT(camera.place().y, 1);
  camera.update(holding({Key::q}), {}, 1);
  EXPECT_NEAR(camera.place().y, 0, 1e-4);
}

float distance_with(std::initializer_list<Key> keys) {
  FlyCamera camera({});
  camera.update(holding(keys), {}, 1);
  return -camera.place().z;
}

TEST(FlyCamera, ShiftIsFaster) { EXPECT_GT(distance_with({Key::w, Key::shift}), distance_with({Key::w})); }

TEST(FlyCamera, StandsStillWhileCtrlAltOrSuperMakesAnotherMeaningOfAKey) {
  for (const Key modifier : {Key::control, Key::alt, Key::super}) {
    for (const Key key : {Key::w, Key::a, Key::s, Key::d, Key::q, Key::e}) {
      FlyCamera camera({});
      camera.update(holding({key, modifier}), {}, 1);
      EXPECT_EQ(camera.place(), CameraPose());
    }
  }
}

TEST(FlyCamera, TheWheelSetsTheSpeedWithinBounds) {
  FlyCamera camera({});
  InputFrame input;
  input.wheel = 1;
  const float before = camera.speed();
  camera.update(input, {}, 0.01F);
  EXPECT_GT(camera.speed(), before);
  input.wheel = -1000;
  camera.update(input, {}, 0.01F);
  EXPECT_GT(camera.speed(), 0);
}

TEST(FlyCamera, ARightDragLooksTheWayItGoes) {
  FlyCamera camera({});
  camera.update(looking(100, -50), {}, 0.01F);
  EXPECT_LT(camera.place().yaw, 0) << "yaw turns left";
  EXPECT_GT(camera.place().pitch, 0);
}

TEST(FlyCamera, StandsStillWhileTheOverlayHasPointerAndKeys) {
  FlyCamera camera({});
  InputFrame input = looking(100, 100);
  input.keys_down.set(static_cast<std::size_t>(Key::w));
  input.wheel = 3;
  const float speed = camera.speed();
  camera.update(input, {.pointer_free = false, .keyboard_free = false}, 1);
  EXPECT_EQ(camera.place().z, 0);
  EXPECT_EQ(camera.place().yaw, 0);
  EXPECT_EQ(camera.speed(), speed);
}

TEST(FlyCamera, PlacesComeBackInDegreesAndAsAnOption) {
  const CameraPose place{.x = 1.5F, .y = 2, .z = -3, .yaw = 90, .pitch = -10, .field_of_view = 45};
  const CameraPose back = FlyCamera(place).place();
  EXPECT_NEAR(back.yaw, 90, 1e-4);
  EXPECT_NEAR(back.pitch, -10, 1e-4);
  EXPECT_NEAR(back.field_of_view, 45, 1e-4);
  EXPECT_EQ(camera_option(place), "--camera 1.5,2,-3,90,-10,45");
}

}  // namespace
}  // namespace throng::app::fly_camera_test
