#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "throng/render/crowd_draw.h"

namespace throng::render {

inline constexpr int cascade_count = 4;

/// A range of depths: how far in front of the camera things are, in metres along its axis.
struct DepthRange {
  float nearest = 0.0F;
  float farthest = 0.0F;

  friend bool operator==(const DepthRange&, const DepthRange&) = default;
};

/// Returns the depths of all instances, rounded outwards to a few steps, so that they seldom change as a camera moves.
/// Where there is none, it returns the depths of a scene of people.
DepthRange depths_of(const CrowdFrame& frame);

/// A shadow map for a slice of the view frustum. The slice lies in a ball, so that the map has the same size whichever
/// way the camera looks, and the ball moves in steps of texels, so that edges of shadows do not crawl (Valient, "Stable
/// Rendering of Cascaded Shadow Maps", ShaderX6, 2008).
struct Cascade {
  glm::vec3 centre{0.0F};
  float radius = 0.0F;      ///< metres
  float reach = 0.0F;       ///< the depth at which it ends
  float texel = 0.0F;       ///< metres
  glm::mat4 to_clip{1.0F};  ///< x and y -1 to 1 over the map; z 0 towards the sun, 1 away from it
};

/// Directions in which maps lie: x and y along their sides, z towards the sun; all unit.
struct SunAxes {
  glm::vec3 x, y, z;

  glm::vec3 along(const glm::vec3& point) const { return {glm::dot(point, x), glm::dot(point, y), glm::dot(point, z)}; }
};
SunAxes sun_axes(const glm::vec3& to_sun);

/// Cuts the depths into slices that grow with the distance, and lays a map of `side` texels over each.
std::array<Cascade, cascade_count> plan_cascades(const CameraView& camera, const SunAxes& axes,
                                                 const DepthRange& depths, int side);

/// The cascades of a frame as casters are tested against them: all of them at once, along the axes of
/// the sun.
struct CastLimits {
  std::array<float, cascade_count> x{}, y{}, z{};  ///< middles, [cascade]
  std::array<float, cascade_count> reach{};        ///< from the middle; below any radius where nothing may cast
};
/// Nothing casts into a cascade that is not `wanted`.
CastLimits cast_limits(const std::array<Cascade, cascade_count>& cascades, const SunAxes& axes,
                       const std::array<bool, cascade_count>& wanted);

/// Returns for each cascade 1 where something in a ball may cast a shadow into it, else 0. It may be anywhere towards
/// the sun. `centre` is given along the axes of the sun.
inline std::array<std::uint32_t, cascade_count> may_cast(const CastLimits& limits, const glm::vec3& centre,
                                                         float radius) {
  std::array<std::uint32_t, cascade_count> may{};
  for (std::size_t i = 0; i < cascade_count; ++i) {
    const float reach = limits.reach[i] + radius;
    const bool beside = std::abs(centre.x - limits.x[i]) < reach && std::abs(centre.y - limits.y[i]) < reach;
    may[i] = static_cast<std::uint32_t>(beside && centre.z - limits.z[i] > -reach);
  }
  return may;
}

}  // namespace throng::render
