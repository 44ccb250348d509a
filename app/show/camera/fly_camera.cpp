#include "app/show/camera/fly_camera.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

namespace throng::app {
namespace {

constexpr float radians_a_pixel = 0.0035F;
constexpr float usual_view = 0.7F;  // radians; a camera that sees less turns as much less with each pixel
constexpr float times_faster = 4;
constexpr float speed_step = 1.2F;  // of the wheel

float axis(const InputFrame& input, Key negative, Key positive) {
  return static_cast<float>(input.down_alone(positive)) - static_cast<float>(input.down_alone(negative));
}

glm::vec3 direction(const InputFrame& input) {
  return {axis(input, Key::a, Key::d), axis(input, Key::q, Key::e), axis(input, Key::s, Key::w)};
}

float hurry(const InputFrame& input) { return input.down(Key::shift) ? times_faster : 1.0F; }

/// Returns the degrees that camera_at() makes this angle of, where there are such, so that a kept place shows the very
/// same picture.
float degrees_of(float angle) {
  const float degrees = glm::degrees(angle);
  if (glm::radians(degrees) == angle) return degrees;
  constexpr float below = -1e9F, above = 1e9F;
  for (const float towards : {below, above}) {
    const float near = std::nextafter(degrees, towards);
    if (glm::radians(near) == angle) return near;
  }
  return degrees;
}

}  // namespace

bool orbits(const InputFrame& input) {
  return input.down(MouseButton::middle) || (input.down(MouseButton::left) && input.down(Key::alt));
}

render::Camera camera_at(const CameraPose& place) {
  return {.position = {place.x, place.y, place.z},
          .yaw = glm::radians(place.yaw),
          .pitch = std::clamp(glm::radians(place.pitch), -render::Camera::pitch_limit, render::Camera::pitch_limit),
          .vertical_view = glm::radians(place.field_of_view)};
}

CameraPose place_of(const render::Camera& camera) {
  return {.x = camera.position.x,
          .y = camera.position.y,
          .z = camera.position.z,
          .yaw = degrees_of(camera.yaw),
          .pitch = degrees_of(camera.pitch),
          .field_of_view = degrees_of(camera.vertical_view)};
}

std::string camera_option(const CameraPose& place) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(6);
  text << "--camera " << place.x << ',' << place.y << ',' << place.z << ',' << place.yaw << ',' << place.pitch << ','
       << place.field_of_view;
  return text.str();
}

void FlyCamera::update(const InputFrame& input, const FlyControls& controls, float seconds) {
  render::FlyInput flight;
  if (controls.pointer_free) {
    set_speed(speed_ * std::pow(speed_step, input.wheel));
    if (input.down(MouseButton::right)) {
      const float turn = radians_a_pixel * std::min(1.0F, camera_.vertical_view / usual_view);
      flight.turn_left = -input.moved_x * turn;
      flight.turn_up = -input.moved_y * turn;
    }
  }
  if (controls.keyboard_free) flight.move = direction(input);
  flight.speed = speed_ * hurry(input);
  camera_ = render::fly(camera_, flight, seconds);
  if (controls.pointer_free && orbits(input)) {
    camera_ = render::orbit(camera_, controls.orbit_about, -input.moved_x * radians_a_pixel,
                            -input.moved_y * radians_a_pixel);
  }
  camera_.position = glm::clamp(camera_.position, glm::vec3(-farthest_camera), glm::vec3(farthest_camera));
}

}  // namespace throng::app
