#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "assets/mannequin/surface.h"

namespace throng::mannequin {

inline constexpr double position_step = 1.0 / 65536;  ///< Metres; positions are whole multiples of it.
inline constexpr double normal_step = 1.0 / 4096;
inline constexpr double weight_step = 1.0 / 256;

/// One vertex as it is written: what is shared by faces of one region and paint.
struct MeshVertex {
  glm::vec3 position;
  glm::vec3 normal;
  std::array<std::uint8_t, 4> joints;
  std::array<float, 4> weights;        ///< Descending, whole multiples of weight_step, exactly one in sum.
  std::array<std::uint8_t, 4> colour;  ///< Linear albedo factor; alpha is 255.
  float region;
};

struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::array<std::uint16_t, 3>> triangles;  ///< Counter-clockwise seen from outside.
};

/// Triangles, normals, baked occlusion, at most four joints per vertex; everything rounded to its step.
Mesh make_mesh(const Surface& surface);

}  // namespace throng::mannequin
