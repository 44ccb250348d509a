#include "app/show/viewer/turntable.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace throng::app {
namespace {

constexpr float turned_a_pixel = 0.008F;
constexpr float radians_a_second = 0.7F;
constexpr float step_of_wheel = 0.88F, nearest_seen = 0.2F, farthest_seen = 4.0F;
constexpr float steepest = -1.5F, flattest = -0.03F;  // above the ground that the character stands on

}  // namespace

void Turntable::update(const InputFrame& input, const FlyControls& controls) {
  if (!controls.pointer_free) return;
  nearness_ = std::clamp(nearness_ * std::pow(step_of_wheel, input.wheel), nearest_seen, farthest_seen);
  if (!input.down(MouseButton::left) && !input.down(MouseButton::right)) return;
  yaw_ = std::remainder(yaw_ - input.moved_x * turned_a_pixel, 2.0F * std::numbers::pi_v<float>);
  pitch_ = std::clamp(pitch_ - input.moved_y * turned_a_pixel, steepest, flattest);
}

void Turntable::turn(float seconds) {
  yaw_ = std::remainder(yaw_ + seconds * radians_a_second, 2.0F * std::numbers::pi_v<float>);
}

void Turntable::face_front() {
  yaw_ = first_yaw;
  pitch_ = first_pitch;
  nearness_ = 1.0F;
}

// Each point of both rims needs a distance, at which it touches an edge of the picture.
float Turntable::distance_to_see(const render::Camera& camera, float aspect) const {
  constexpr int points = 48;
  const glm::vec3 ahead = render::forward(camera), right = render::right(camera), up = glm::cross(right, ahead);
  const float tall = std::tan(camera.vertical_view / 2), wide = tall * aspect;
  float distance = 0.0F;
  for (int point = 0; point < points; ++point) {
    const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(point) / points;
    for (const float height : {-half_height_, half_height_}) {
      const glm::vec3 rim(radius_ * std::cos(angle), height, radius_ * std::sin(angle));
      const float near = -glm::dot(rim, ahead);
      distance =
          std::max({distance, near + std::abs(glm::dot(rim, right)) / wide, near + std::abs(glm::dot(rim, up)) / tall});
    }
  }
  return distance;
}

render::Camera Turntable::camera(float aspect, float covered) const {
  render::Camera camera{.position = {}, .yaw = yaw_, .pitch = pitch_};
  const float distance = nearness_ * distance_to_see(camera, aspect * (1.0F - covered));
  const float half_width = distance * std::tan(camera.vertical_view / 2) * aspect;
  camera.position = centre_ - distance * render::forward(camera) + covered * half_width * render::right(camera);
  return camera;
}

}  // namespace throng::app
