#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "throng/render/crowd_mesh_data.h"

namespace throng::render::test {

inline constexpr std::size_t doll_joints = 6;
inline constexpr std::size_t doll_palette_bytes = doll_joints * 48;
enum DollJoint : std::uint16_t { hips, chest, head, left_arm, right_arm, legs };

/// A matrix of a palette as animation writes it: 3x4, by rows.
struct PaletteRows {
  float rows[3][4];
};
using DollPalette = std::vector<PaletteRows>;  ///< doll_joints entries

/// A hand-made figure of boxes, 1.75 m tall, with six joints and all five tint regions. Two joints move the vertices of
/// its trunk. It owns the arrays that its mesh data points to.
class Doll {
 public:
  Doll();
  CrowdMeshData mesh_data() const;

  std::size_t vertex_count() const { return positions_.size(); }
  /// These two functions compute a vertex of the mesh in model space, moved by a palette, on the CPU in double.
  glm::dvec3 skinned_position(std::size_t vertex, const DollPalette& palette) const;
  glm::dvec3 skinned_normal(std::size_t vertex, const DollPalette& palette) const;

 private:
  struct Influence {
    std::array<std::uint16_t, 4> joints;
    std::array<float, 4> weights;
  };

  void add_box(const glm::vec3& low, const glm::vec3& high, std::uint8_t region, Influence lower, Influence upper);
  glm::dmat4 blended(std::size_t vertex, const DollPalette& palette) const;

  std::vector<glm::vec3> positions_;
  std::vector<glm::vec3> normals_;
  std::vector<std::uint8_t> regions_;
  std::vector<std::uint16_t> joints_;
  std::vector<float> weights_;
  std::vector<std::uint32_t> indices_;
};

/// Makes a pose with raised arms and a trunk bent by `bend` radians. No two joints have the same matrix.
DollPalette doll_pose(float bend);

}  // namespace throng::render::test
