#include "app/show/stage/picking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace throng::app {
namespace {

/// Distances along the ray, between which it is inside; empty where `to` is not above `from`.
struct Stretch {
  float from = -std::numeric_limits<float>::infinity();
  float to = std::numeric_limits<float>::infinity();
};

constexpr Stretch nowhere{0.0F, 0.0F};

Stretch between_planes(float start, float speed, float lowest, float highest) {
  if (speed == 0.0F) return start > lowest && start < highest ? Stretch() : nowhere;
  Stretch inside{(lowest - start) / speed, (highest - start) / speed};
  if (inside.from > inside.to) std::swap(inside.from, inside.to);
  return inside;
}

// Seen from above: |start + t way| = radius.
Stretch in_circle(const glm::vec2& start, const glm::vec2& way, float radius) {
  const float a = glm::dot(way, way), b = glm::dot(start, way), c = glm::dot(start, start) - radius * radius;
  if (a == 0.0F) return c < 0.0F ? Stretch() : nowhere;
  const float discriminant = b * b - a * c;
  if (discriminant <= 0.0F) return nowhere;
  const float root = std::sqrt(discriminant);
  return {(-b - root) / a, (-b + root) / a};
}

}  // namespace

PickRay ray_through(const render::Camera& camera, const glm::vec2& pixel, const glm::vec2& size) {
  const glm::vec3 ahead = render::forward(camera), aside = render::right(camera), up = glm::cross(aside, ahead);
  const float half_height = std::tan(camera.vertical_view * 0.5F);
  const float x = (2.0F * pixel.x / size.x - 1.0F) * half_height * size.x / size.y;
  const float y = (1.0F - 2.0F * pixel.y / size.y) * half_height;
  return {camera.position, glm::normalize(ahead + x * aside + y * up)};
}

std::optional<Pick> pick(const PickRay& ray, std::span<const UprightBody> bodies) {
  std::optional<Pick> nearest;
  for (const UprightBody& body : bodies) {
    const glm::vec3 start = ray.origin - body.foot;
    const Stretch across = in_circle({start.x, start.z}, {ray.direction.x, ray.direction.z}, body.radius);
    const Stretch along = between_planes(start.y, ray.direction.y, 0.0F, body.height);
    const float enters = std::max(across.from, along.from);
    if (enters <= 0.0F || enters >= std::min(across.to, along.to)) continue;
    if (!nearest || enters < nearest->distance) nearest = Pick{body.agent, enters};
  }
  return nearest;
}

}  // namespace throng::app
