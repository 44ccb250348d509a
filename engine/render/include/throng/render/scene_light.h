#pragma once

#include <glm/vec3.hpp>

namespace throng::render {

/// Says where the sun stands, what the sky is like, and how bright the picture is.
struct SceneLight {
  float sun_elevation = 56.0F;  ///< degrees above the horizon, -90 to 90; below -2 the moon shines instead
  float sun_azimuth = 62.0F;    ///< degrees from +Z towards +X
  float clouds = 0.35F;         ///< the share of the sky that they cover, 0 to 1; at 1 the sun is behind them
  float exposure = 0.0F;        ///< stops brighter than suits the light

  friend bool operator==(const SceneLight&, const SceneLight&) = default;
};

/// Gives the unit vector to a place in the sky; degrees as above.
glm::vec3 direction_at(float elevation, float azimuth);

/// Says whether the moon casts the shadows, because the sun has set.
inline bool is_moonlit(const SceneLight& light) { return light.sun_elevation < -2.0F; }

/// Says whether sun or moon casts shadows: closed clouds leave light from everywhere alone.
inline bool casts_shadows(const SceneLight& light) { return light.clouds < 1.0F; }

/// Gives the unit vector to the sun, or to the moon once that shines instead. It is always above the horizon.
glm::vec3 to_brightest(const SceneLight& light);

}  // namespace throng::render
