#pragma once

#include <cstddef>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace throng::render {

inline constexpr int sky_harmonics = 9;

/// Block 1 of every scene program: the light of sun and sky. `shaders/light_uniforms.glsl` repeats the layout (std140).
/// All light is linear and already exposed.
///
///      0  to the sun x y z, unit      night: 0 by day, 1 when windows and lamps are lit
///     16  sun light r g b             the light that a white surface that faces the sun reflects
///     32  sky harmonics               nine of r g b and nothing: a polynomial of the normal, which gives what a white
///                                     surface reflects of sky and ground
///    176  haze r g b                  where the sun is not; x of the unit way to the sun along the ground
///    192  haze at the sun r g b       is added to it towards the sun; z of that way
///    208  clearing r g b              1 / metres: how fast haze hides the light behind it
struct LightUniforms {
  glm::vec3 to_sun;
  float night;
  glm::vec4 sun_light;
  glm::vec4 harmonics[sky_harmonics];
  glm::vec4 haze;
  glm::vec4 haze_at_sun;
  glm::vec4 clearing;
};
static_assert(sizeof(LightUniforms) == 224);
static_assert(offsetof(LightUniforms, night) == 12);
static_assert(offsetof(LightUniforms, sun_light) == 16);
static_assert(offsetof(LightUniforms, harmonics) == 32);
static_assert(offsetof(LightUniforms, haze) == 176);
static_assert(offsetof(LightUniforms, clearing) == 208);

}  // namespace throng::render
