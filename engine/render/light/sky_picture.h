#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "throng/render/scene_light.h"

#include "engine/render/light/light_uniforms.h"

namespace throng::render {

/// Unfolds the upper half of an octahedron into the square 0..1, and back: the horizon is its edge, the zenith its
/// middle. shaders/lighting.glsl does the same.
glm::vec2 sky_place(const glm::vec3& direction);
glm::vec3 sky_direction(const glm::vec2& place);

/// The sky as it looks from the ground, and the light that it gives; all linear and exposed.
class SkyPicture {
 public:
  static constexpr int side = 640;             ///< pixels of the map
  static constexpr int environment_side = 64;  ///< pixels of a face of the finest environment
  static constexpr int environment_levels = 6;

  explicit SkyPicture(const SceneLight& light);

  const LightUniforms& uniforms() const { return uniforms_; }

  /// Returns the map, [row][column], of sky_place; alpha is the share that clouds leave of the light behind them.
  const std::vector<glm::vec4>& map() const { return map_; }

  /// Returns what a direction, unit, looks like from afar: the sky without the sun's disc, or the ground.
  glm::vec3 radiance(const glm::vec3& direction) const;

  /// Returns what a direction looks like to people in a town. Below the roofs there are walls instead of sky while the
  /// sun is low: walls that it shines on are bright and warm, walls on its side are dim, and the ground lies in the
  /// shade of the walls.
  glm::vec3 radiance_in_town(const glm::vec3& direction) const;

  /// Computes a face of the cube that surfaces mirror, in the order and the directions of OpenGL 4.5, 8.13. The level
  /// `environment_levels` - 1 is for surfaces of roughness 1.
  std::vector<glm::vec4> environment(int face, int level) const;

 private:
  static constexpr int coarse_side = 48;  // pixels

  void light_air(const SceneLight& light);
  void light_clouds(const SceneLight& light);
  void light_ground();
  void sum_up();

  LightUniforms uniforms_{};
  std::vector<glm::vec4> coarse_;  // the map without clouds at first, then with them
  std::vector<glm::vec4> map_;
  glm::vec3 cloud_sun_{0.0F};  // the sun's light on clouds
  glm::vec3 ground_{0.0F};
  glm::vec3 walls_in_shade_{0.0F}, ground_in_shade_{0.0F};
  float town_ = 0.0F;  // the share of what is below the roofs that walls hide or keep the sun from
};

}  // namespace throng::render
