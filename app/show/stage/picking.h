#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "throng/render/camera.h"

namespace throng::app {

/// A ray from the camera through a point of the picture, in world space.
struct PickRay {
  glm::vec3 origin{0.0F};
  glm::vec3 direction{0.0F, 0.0F, -1.0F};  ///< unit
};

/// Returns the ray through `pixel`, counted from the top left of a picture of `size` pixels. Width and height of the
/// picture are above 0.
PickRay ray_through(const render::Camera& camera, const glm::vec2& pixel, const glm::vec2& size);

/// An upright cylinder around an agent.
struct UprightBody {
  std::uint32_t agent = 0;
  glm::vec3 foot{0.0F};  ///< middle of its lower end, metres, world space
  float radius = 0.0F;   ///< metres
  float height = 0.0F;   ///< metres
};

struct Pick {
  std::uint32_t agent = 0;
  float distance = 0.0F;  ///< metres along the ray, to where it enters
};

/// Returns the body that the ray enters first; nothing if it enters none. A body that the ray begins in is not seen
/// from outside, so it is passed over.
std::optional<Pick> pick(const PickRay& ray, std::span<const UprightBody> bodies);

}  // namespace throng::app
