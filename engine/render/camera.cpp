#include "throng/render/camera.h"

#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

namespace throng::render {
namespace {

const glm::vec3 world_up{0.0F, 1.0F, 0.0F};

/// Is right-handed and maps the near plane to depth 1 and the far plane to depth 0. Floats are densest around 0, which
/// makes up for the precision that the division by distance takes from far away.
glm::mat4 reversed_perspective(float vertical_view, float aspect, float near_distance, float far_distance) {
  const float focal = 1.0F / std::tan(vertical_view * 0.5F);
  glm::mat4 projection(0.0F);
  projection[0][0] = focal / aspect;
  projection[1][1] = focal;
  projection[2][2] = near_distance / (far_distance - near_distance);
  projection[2][3] = -1.0F;
  projection[3][2] = far_distance * near_distance / (far_distance - near_distance);
  return projection;
}

glm::vec3 up(const Camera& camera) { return glm::cross(right(camera), forward(camera)); }

// How far a way goes to the right, up and ahead.
glm::vec3 seen_by(const Camera& camera, const glm::vec3& way) {
  return {glm::dot(way, right(camera)), glm::dot(way, up(camera)), glm::dot(way, forward(camera))};
}

glm::vec4 normalized(const glm::vec4& plane) { return plane / glm::length(glm::vec3(plane)); }

}  // namespace

glm::vec3 forward(const Camera& camera) {
  return {-std::sin(camera.yaw) * std::cos(camera.pitch), std::sin(camera.pitch),
          -std::cos(camera.yaw) * std::cos(camera.pitch)};
}

glm::vec3 right(const Camera& camera) { return {std::cos(camera.yaw), 0.0F, -std::sin(camera.yaw)}; }

CameraView view_of(const Camera& camera, float aspect) {
  CameraView view;
  view.position = camera.position;
  view.view = glm::lookAtRH(camera.position, camera.position + forward(camera), world_up);
  view.projection = reversed_perspective(camera.vertical_view, aspect, Camera::near_distance, Camera::far_distance);
  return view;
}

std::array<glm::vec4, 6> frustum_planes(const CameraView& view) {
  const glm::mat4 rows = glm::transpose(view.projection * view.view);
  return {normalized(rows[3] + rows[0]), normalized(rows[3] - rows[0]), normalized(rows[3] + rows[1]),
          normalized(rows[3] - rows[1]), normalized(rows[3] - rows[2]), normalized(rows[2])};
}

float pixels_tall(const Camera& camera, float image_height, float height, float distance) {
  const float seen_height = 2.0F * std::tan(camera.vertical_view * 0.5F) * std::max(distance, Camera::near_distance);
  return image_height * height / seen_height;
}

Camera fly(const Camera& camera, const FlyInput& input, float seconds) {
  Camera next = camera;
  next.yaw = std::remainder(camera.yaw + input.turn_left, glm::two_pi<float>());
  next.pitch = std::clamp(camera.pitch + input.turn_up, -Camera::pitch_limit, Camera::pitch_limit);
  const glm::vec3 direction = right(next) * input.move.x + world_up * input.move.y + forward(next) * input.move.z;
  next.position += direction * (input.speed * seconds);
  return next;
}

Camera orbit(const Camera& camera, const glm::vec3& about, float turn_left, float turn_up) {
  const Camera turned = fly(camera, {.turn_left = turn_left, .turn_up = turn_up}, 0.0F);
  const glm::vec3 way = about - camera.position, seen = seen_by(camera, way);
  Camera next = turned;
  next.position = about - (seen.x * right(turned) + seen.y * up(turned) + seen.z * forward(turned));
  return next;
}

}  // namespace throng::render
