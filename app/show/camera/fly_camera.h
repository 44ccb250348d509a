#pragma once

#include <algorithm>
#include <string>

#include <glm/vec3.hpp>

#include "throng/render/camera.h"

#include "app/settings/settings.h"
#include "app/show/camera/input.h"

namespace throng::app {

/// Converts between the degrees of the command line and the radians of the camera.
render::Camera camera_at(const CameraPose& place);
CameraPose place_of(const render::Camera& camera);

/// Returns "--camera x,y,z,yaw,pitch,fov", the option that puts a camera at this place.
std::string camera_option(const CameraPose& place);

/// Mouse and keyboard of a frame, as far as the camera may use them.
struct FlyControls {
  bool pointer_free = true;     ///< the overlay does not use it
  bool keyboard_free = true;    ///< no text field takes keys
  glm::vec3 orbit_about{0.0F};  ///< the point of the world that a drag turns about
};

/// The speed at which a camera flies, in metres a second.
inline constexpr float lowest_fly_speed = 0.25F, highest_fly_speed = 250, usual_fly_speed = 6;

/// Returns whether a drag turns the camera about a point.
bool orbits(const InputFrame& input);

/// W A S D and Q E fly, a drag with the right button looks around, a drag with the middle button, or with Alt and the
/// left one, turns about a point. The wheel sets the speed, and Shift is faster. With Ctrl, Alt or Super held, keys
/// mean something else and do not fly.
class FlyCamera {
 public:
  explicit FlyCamera(const CameraPose& place) : camera_(camera_at(place)) {}

  void update(const InputFrame& input, const FlyControls& controls, float seconds);

  [[nodiscard]] const render::Camera& camera() const { return camera_; }
  [[nodiscard]] CameraPose place() const { return place_of(camera_); }
  [[nodiscard]] float speed() const { return speed_; }
  void set_speed(float speed) { speed_ = std::clamp(speed, lowest_fly_speed, highest_fly_speed); }
  void set_camera(const render::Camera& camera) { camera_ = camera; }

 private:
  render::Camera camera_;
  float speed_ = usual_fly_speed;
};

}  // namespace throng::app
