#include "app/show/camera/camera_path.h"

#include <cmath>
#include <numbers>

namespace throng::app {
namespace {

constexpr double whole_turn = 2.0 * std::numbers::pi;
constexpr double orbit_seconds = 60.0;
constexpr double pan_seconds = 10.0;
constexpr double pan_radians = std::numbers::pi / 6.0;

render::Camera orbited(render::Camera camera, double angle) {
  const auto cosine = static_cast<float>(std::cos(angle)), sine = static_cast<float>(std::sin(angle));
  const glm::vec3 from = camera.position;
  camera.position = {from.x * cosine + from.z * sine, from.y, from.z * cosine - from.x * sine};
  camera.yaw += static_cast<float>(angle);
  return camera;
}

}  // namespace

render::Camera along(CameraPath path, const render::Camera& start, double seconds) {
  if (path == CameraPath::orbit) return orbited(start, whole_turn * std::fmod(seconds, orbit_seconds) / orbit_seconds);
  render::Camera camera = start;
  if (path == CameraPath::pan)
    camera.yaw += static_cast<float>(pan_radians * std::sin(whole_turn * seconds / pan_seconds));
  return camera;
}

}  // namespace throng::app
