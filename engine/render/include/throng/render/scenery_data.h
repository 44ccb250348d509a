#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>

namespace throng::render {

/// Says how a surface of scenery takes light.
enum class SceneryKind : std::uint8_t { matt, glass, water, metal };

/// A corner of scenery, as the device reads it.
struct SceneryVertex {
  float position[3];        ///< metres
  float normal[3];          ///< of length 1
  std::uint8_t color[4];    ///< linear red, green and blue; the last is 255
  std::uint8_t glow = 0;    ///< the light that it sends out at night
  std::uint8_t tinted = 0;  ///< 255: the instance's tint multiplies the colour
  std::uint8_t sway = 0;    ///< how far wind moves it, as leaves and flags
  SceneryKind kind = SceneryKind::matt;
};
static_assert(sizeof(SceneryVertex) == 32);

/// One level of detail of a mesh: triangles among its vertices.
struct SceneryLodData {
  std::vector<std::uint32_t> indices;
  float error = 0.0F;  ///< metres that its surface is off the finest
};

/// A thing that stands in a place, in metres: +Y is up, its front faces +Z, and it stands on the origin.
struct SceneryMeshData {
  std::string name;
  std::vector<SceneryVertex> vertices;
  std::vector<SceneryLodData> lods;  ///< the finest first
};

/// The tint that changes no colour.
inline constexpr std::uint32_t no_tint = 0xFFFFFFFF;

/// Says where one thing stands.
struct SceneryInstance {
  std::uint32_t mesh = 0;        ///< its index in the order of loading
  glm::mat4x3 place{1.0F};       ///< from the mesh to the world
  std::uint32_t tint = no_tint;  ///< sRGB, red in the lowest byte
};

/// A lamp of a place, which shines at night.
struct SceneryLamp {
  glm::vec3 position{0.0F};  ///< metres
  glm::vec3 color{0.0F};     ///< linear: as a white surface reflects it that faces it at one metre
};

}  // namespace throng::render
