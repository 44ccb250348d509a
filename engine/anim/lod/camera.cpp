#include "throng/camera.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "engine/base/glm_numbers.h"

namespace throng {

Camera camera_of(const Vec3& position, const Vec3& forward, const float (&clip_from_world)[16], int pixels_tall) {
  Camera camera{.position = position, .forward = forward};
  const auto row = [&](int r) {
    return glm::vec4(clip_from_world[r], clip_from_world[4 + r], clip_from_world[8 + r], clip_from_world[12 + r]);
  };
  for (int side = 0; side < 6; ++side) {
    const glm::vec4 plane = row(3) + (side % 2 == 0 ? 1.0F : -1.0F) * row(side / 2);
    const float length = glm::length(glm::vec3(plane));
    for (int i = 0; i < 4; ++i) {
      camera.frustum[static_cast<std::size_t>(side)][static_cast<std::size_t>(i)] =
          length > 0.0F ? plane[i] / length : 0.0F;
    }
  }
  // The second row is the projection's scale times a unit vector.
  camera.pixels_per_unit = 0.5F * static_cast<float>(pixels_tall) * glm::length(glm::vec3(row(1)));
  return camera;
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
