#include "throng/camera.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "engine/base/glm_numbers.h"

namespace throng {

namespace {

using Plane = std::array<float, 4>;

/// Returns a plane with a unit normal; zeros, which hold everything, where the normal is no more than rounding.
Plane unit_plane(const glm::vec4& plane, float least) {
  const float length = glm::length(glm::vec3(plane));
  if (!(length > least)) return {};
  return {plane.x / length, plane.y / length, plane.z / length, plane.w / length};
}

/// Returns the near and the far plane. On a perspective matrix a depth is a + b / w, where w is the distance: a is at
/// least 1, or 0 at most if depths are reversed, and then above -1 only if they are from 0 to 1.
std::array<Plane, 2> depth_planes(const glm::vec4& z, const glm::vec4& w) {
  constexpr float rounding = 1e-6F;  // of normals that cancel each other out
  const float square = glm::dot(glm::vec3(w), glm::vec3(w));
  const float scale = std::max(std::sqrt(square), glm::length(glm::vec3(z)));
  const float a = square > 0.0F ? glm::dot(glm::vec3(z), glm::vec3(w)) / square : 0.0F;
  const bool is_reversed = square > 0.0F && a < 0.5F;
  const glm::vec4 low = is_reversed && a > -1.0F + rounding ? z : w + z;
  const Plane lower = unit_plane(low, rounding * scale), upper = unit_plane(w - z, rounding * scale);
  return is_reversed ? std::array{upper, lower} : std::array{lower, upper};
}

}  // namespace

Camera camera_of(const Vec3& position, const Vec3& forward, const float (&clip_from_world)[16], int pixels_tall) {
  const auto row = [&](int r) {
    return glm::vec4(clip_from_world[r], clip_from_world[4 + r], clip_from_world[8 + r], clip_from_world[12 + r]);
  };
  const auto side = [&](const glm::vec4& axis) { return unit_plane(row(3) + axis, 0.0F); };
  const auto [near_plane, far_plane] = depth_planes(row(2), row(3));
  // The second row is the projection's scale times a unit vector.
  return {.position = position,
          .forward = forward,
          .frustum = {side(row(0)), side(-row(0)), side(row(1)), side(-row(1)), near_plane, far_plane},
          .pixels_per_unit = 0.5F * static_cast<float>(pixels_tall) * glm::length(glm::vec3(row(1)))};
}

Camera camera_of(const Vec3& position, const Vec3& forward, const Mat4& clip_from_world, int pixels_tall) {
  float numbers[16];
  std::copy_n(&clip_from_world.columns[0][0], 16, numbers);
  return camera_of(position, forward, numbers, pixels_tall);
}

// A frustum holds a ball that moves along the light if it holds the ball at either end.
void include_casters(Camera& camera, const Vec3& to_light, float height) {
  constexpr float longest = 14.0F, of_height = 1.8F;  // metres: a person's shadow
  const float length = std::min(height / std::max(to_light.y, 1e-3F), longest / of_height * height);
  for (std::array<float, 4>& plane : camera.frustum) {
    plane[3] += length * std::max(-glm::dot(glm::vec3(plane[0], plane[1], plane[2]), to_glm(to_light)), 0.0F);
  }
}

}  // namespace throng
