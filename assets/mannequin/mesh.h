#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "assets/mannequin/surface.h"

namespace throng::mannequin {

inline constexpr double position_step = 1.0 / 65536;  ///< Metres; positions are whole multiples of it.
inline constexpr double normal_step = 1.0 / 4096;
inline constexpr double weight_step = 1.0 / 256;

/// A point of the body's surface with all that is the same for every face that meets there.
struct SkinPoint {
  glm::dvec3 position;
  glm::dvec3 normal{0};
  double openness = 1;  ///< 0 to 1, see bake_openness
  Weights weights;
};

/// A face of any number of corners, counter-clockwise seen from outside.
struct SkinFace {
  std::vector<std::size_t> corners;
  Region region;
  std::vector<glm::dvec3> paint;  ///< Per corner.
  FaceNotes notes = {};
  std::vector<glm::dvec2> pattern = {};  ///< Per corner, metres over the cloth; empty where nothing has a pattern.
};

/// The body before it is cut into triangles.
struct Skin {
  std::vector<SkinPoint> points;
  std::vector<SkinFace> faces;
};

/// One vertex as it is written: what is shared by faces of one region and paint.
struct MeshVertex {
  glm::vec3 position;
  glm::vec3 normal;
  std::array<std::uint8_t, 4> joints;
  std::array<float, 4> weights;        ///< Descending, whole multiples of weight_step, exactly one in sum.
  std::array<std::uint8_t, 4> colour;  ///< Linear albedo factor; alpha is 255.
  float region;
  glm::vec3 shape;  ///< Whole multiples of shape_step, as `hair`; see Shape.
  glm::vec2 hair;
  std::uint32_t point = 0;  ///< Of the skin.
  float trim = 0;
  glm::vec2 pattern{0};
  unsigned char piece = 0;
  glm::vec4 face{0};  ///< See assets/wardrobe/face_shares.h.
};

struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::array<std::uint16_t, 3>> triangles;  ///< Counter-clockwise seen from outside.
};

/// The points of a surface, not below the ground, each rounded to its step, and its faces.
Skin skin_of(const Surface& surface);

/// Faces cut along their shortest diagonals.
std::vector<std::array<std::size_t, 3>> triangles_of(const Skin& skin);

/// Normals weighted by the angle at the point, of the faces rather than of the triangles cut from them; rounded.
void compute_normals(Skin& skin);

/// Cuts a skin into triangles. A vertex has at most four joints. Everything is rounded to its step.
Mesh make_mesh(const Skin& skin);

}  // namespace throng::mannequin
