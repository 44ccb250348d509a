#pragma once

#include <glm/vec3.hpp>

#include "throng/render/camera.h"

#include "app/show/camera/fly_camera.h"
#include "app/show/camera/input.h"

namespace throng::app {

/// A camera that goes round an upright cylinder and keeps it in the picture. A drag with the left or the right button
/// turns it, the wheel goes nearer or farther.
class Turntable {
 public:
  Turntable(const glm::vec3& centre, float radius, float half_height)
      : centre_(centre), radius_(radius), half_height_(half_height) {}

  /// Turns as the mouse asks, while the pointer is free.
  void update(const InputFrame& input, const FlyControls& controls);
  /// Turns on by itself.
  void turn(float seconds);
  /// Goes back to the first view.
  void face_front();

  /// Returns the camera for a picture of `aspect`, whose right share `covered` (0 to below 1) a panel hides. The
  /// cylinder just fits into the rest.
  [[nodiscard]] render::Camera camera(float aspect, float covered) const;

 private:
  float distance_to_see(const render::Camera& camera, float aspect) const;

  glm::vec3 centre_;
  float radius_, half_height_;
  float yaw_ = first_yaw, pitch_ = first_pitch;  // radians, of the camera
  float nearness_ = 1.0F;                        // share of the distance at which the cylinder just fits

  static constexpr float first_yaw = 0.5F, first_pitch = -0.22F;
};

}  // namespace throng::app
