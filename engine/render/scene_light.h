#pragma once

namespace throng::render {

/// Says where the sun stands, what the sky is like, and how bright the picture is.
struct SceneLight {
  float sun_elevation = 47.0F;  ///< degrees above the horizon, -90 to 90; from -6 on the moon shines instead
  float sun_azimuth = 49.0F;    ///< degrees from +Z towards +X
  float clouds = 0.35F;         ///< the share of the sky that they cover, 0 to 1; at 1 the sun is behind them
  float exposure = 0.0F;        ///< stops brighter than what suits the light

  friend bool operator==(const SceneLight&, const SceneLight&) = default;
};

}  // namespace throng::render
