#pragma once

#include <array>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "throng/render/crowd_draw.h"

namespace throng::render {

/// Takes the picture from a place and in a direction. At yaw and pitch 0 it looks along -Z; yaw turns it left (about
/// +Y), pitch up.
struct Camera {
  glm::vec3 position{0.0F, 1.7F, 5.0F};
  float yaw = 0.0F;                      ///< radians, wraps
  float pitch = 0.0F;                    ///< radians, within +-pitch_limit
  float vertical_view = 0.87266462599F;  ///< radians, 50 degrees

  friend bool operator==(const Camera&, const Camera&) = default;

  static constexpr float near_distance = 0.05F;  ///< metres
  static constexpr float far_distance = 4000.0F;
  static constexpr float pitch_limit = 1.55F;
};

glm::vec3 forward(const Camera& camera);
glm::vec3 right(const Camera& camera);

/// Gives the matrices for CrowdFrame. `aspect` is width / height. Depth is reversed: 1 at the near plane, 0 at the far
/// one.
CameraView view_of(const Camera& camera, float aspect);

/// Gives the planes of the view frustum: left, right, bottom, top, near, far. Their unit normals point inwards. A
/// sphere is outside when dot(plane.xyz, centre) + plane.w < -radius for any of them.
std::array<glm::vec4, 6> frustum_planes(const CameraView& view);

/// Gives the height in pixels of an object of `height` metres at `distance` metres, in a picture `image_height` pixels
/// high.
float pixels_tall(const Camera& camera, float image_height, float height, float distance);

/// Steers the fly camera for one frame.
struct FlyInput {
  glm::vec3 move{0.0F};    ///< right, up, forward; each -1..1
  float turn_left = 0.0F;  ///< radians
  float turn_up = 0.0F;    ///< radians
  float speed = 6.0F;      ///< metres a second
};

/// Gives the camera as it is `seconds` later. It moves up along the world's axis, so that level flight stays level.
Camera fly(const Camera& camera, const FlyInput& input, float seconds);

/// Turns the camera about a point, which stays where it is in the picture. `turn_left` and `turn_up` are radians by
/// which the camera turns; it never looks straight up or down.
Camera orbit(const Camera& camera, const glm::vec3& about, float turn_left, float turn_up);

}  // namespace throng::render
