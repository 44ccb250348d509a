#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "throng/render/scenery_data.h"

#include "engine/render/gl/handles.h"
#include "engine/render/light/shadow_uniforms.h"

namespace throng::render {

/// The light of lamps on a white surface at breast height that faces upwards, seen from above.
struct LampLight {
  static constexpr int side = 512;  ///< pixels

  glm::vec2 corner{0.0F};         ///< x and z in metres
  float metres = 0.0F;            ///< of a side; 0: there are no lamps
  float ceiling = 0.0F;           ///< metres: higher points are not lit
  std::vector<glm::vec4> pixels;  ///< [row along z][column along x]
};

/// Sums up the light of lamps.
LampLight sum_of_lamps(std::span<const SceneryLamp> lamps);

/// Holds the light of the lamps of a place on the device, for shaders/lamps.glsl.
class LampMap {
 public:
  /// Replaces the lamps.
  void place(std::span<const SceneryLamp> lamps);

  bool has_lamps() const { return static_cast<bool>(map_); }

  /// Binds the map and says in `uniforms` where it lies.
  void describe(ShadowUniforms& uniforms) const;

 private:
  gl::Texture map_;  // without storage where there are no lamps
  glm::vec4 lies_at_{0.0F};
};

}  // namespace throng::render
