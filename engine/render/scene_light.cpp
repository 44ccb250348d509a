#include "throng/render/scene_light.h"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

namespace throng::render {
namespace {

constexpr float moon_elevation = 38.0F, from_sun_to_moon = 150.0F;  // degrees
constexpr float lowest_sun = 0.5F;  // degrees: lower, its shadows are endless and no longer seen

}  // namespace

glm::vec3 direction_at(float elevation, float azimuth) {
  const float up = glm::radians(elevation), around = glm::radians(azimuth);
  return {std::cos(up) * std::sin(around), std::sin(up), std::cos(up) * std::cos(around)};
}

glm::vec3 to_brightest(const SceneLight& light) {
  if (is_moonlit(light)) return direction_at(moon_elevation, light.sun_azimuth + from_sun_to_moon);
  return direction_at(std::max(light.sun_elevation, lowest_sun), light.sun_azimuth);
}

}  // namespace throng::render
