#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace throng::render {

/// Describes the material of the ground at y = 0.
enum class GroundStyle : std::uint32_t {
  paving,  ///< stone slabs everywhere
  street,  ///< asphalt along a closed route, kerbs, and slabs beyond
  pitch,   ///< a marked field of grass, a running track around it, and concrete beyond
};

/// The ground of a scene. Its shape is a loop about the origin: a rectangle of corner centres, with round corners.
struct SceneGround {
  GroundStyle style = GroundStyle::paving;
  float unit = 1.0F;        ///< slabs, lines and kerbs are larger by it
  glm::vec2 core{0.0F};     ///< half sides of the rectangle of corner centres, along x and z, in metres
  float radius = 0.0F;      ///< of the corners, in metres; a street runs along the loop, a pitch lies within it
  float half_width = 0.0F;  ///< of the street, or of the track around a pitch, in metres
  float paved = 0.0F;       ///< metres from the rectangle around the loop to where fields begin; 0: there are none

  friend bool operator==(const SceneGround&, const SceneGround&) = default;
};

}  // namespace throng::render
