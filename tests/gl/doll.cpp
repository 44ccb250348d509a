#include "tests/gl/doll.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

namespace throng::render::test {
namespace {

enum Region : std::uint8_t { skin, hair, shirt, trousers, shoes };

constexpr std::array<std::array<int, 3>, 6> face_axes = {
    {{0, 1, 2}, {0, 1, 2}, {1, 2, 0}, {1, 2, 0}, {2, 0, 1}, {2, 0, 1}}};

glm::mat4 turned_about(const glm::vec3& pivot, float angle, const glm::vec3& axis) {
  return glm::translate(glm::rotate(glm::translate(glm::mat4(1.0F), pivot), angle, axis), -pivot);
}

PaletteRows rows_of(const glm::mat4& matrix) {
  PaletteRows rows{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) rows.rows[row][column] = matrix[column][row];
  }
  return rows;
}

glm::dmat4 matrix_of(const PaletteRows& rows) {
  glm::dmat4 matrix(1.0);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) matrix[column][row] = static_cast<double>(rows.rows[row][column]);
  }
  return matrix;
}

}  // namespace

Doll::Doll() {
  const auto rigid = [](std::uint16_t joint) { return Influence{{joint, joint, 0, 0}, {1.0F, 0.0F, 0.0F, 0.0F}}; };
  const Influence waist{{hips, chest, legs, 0}, {0.5F, 0.3F, 0.2F, 0.0F}};
  const Influence shoulders{{chest, head, left_arm, right_arm}, {0.7F, 0.1F, 0.1F, 0.1F}};
  add_box({-0.22F, 0.90F, -0.12F}, {0.22F, 1.42F, 0.12F}, shirt, waist, shoulders);
  add_box({-0.12F, 1.46F, -0.12F}, {0.12F, 1.66F, 0.12F}, skin, rigid(head), rigid(head));
  add_box({-0.13F, 1.66F, -0.13F}, {0.13F, 1.75F, 0.13F}, hair, rigid(head), rigid(head));
  add_box({0.22F, 0.85F, -0.06F}, {0.34F, 1.40F, 0.06F}, shirt, rigid(left_arm), rigid(left_arm));
  add_box({-0.34F, 0.85F, -0.06F}, {-0.22F, 1.40F, 0.06F}, skin, rigid(right_arm), rigid(right_arm));
  add_box({-0.20F, 0.10F, -0.11F}, {0.20F, 0.90F, 0.11F}, trousers, rigid(legs), waist);
  add_box({-0.21F, 0.00F, -0.12F}, {0.21F, 0.10F, 0.20F}, shoes, rigid(legs), rigid(legs));
}

void Doll::add_box(const glm::vec3& low, const glm::vec3& high, std::uint8_t region, Influence lower, Influence upper) {
  for (std::size_t face = 0; face < face_axes.size(); ++face) {
    const auto [across, up, out] = face_axes.at(face);
    const bool outward = face % 2 == 0;
    const auto first = static_cast<std::uint32_t>(positions_.size());
    for (int corner = 0; corner < 4; ++corner) {
      glm::vec3 position = low;
      position[out] = outward ? high[out] : low[out];
      position[across] = ((corner & 1) != 0) == outward ? high[across] : low[across];
      position[up] = (corner & 2) != 0 ? high[up] : low[up];
      glm::vec3 normal(0.0F);
      normal[out] = outward ? 1.0F : -1.0F;
      positions_.push_back(position);
      normals_.push_back(normal);
      regions_.push_back(region);
      const Influence& influence = position.y > low.y ? upper : lower;
      joints_.insert(joints_.end(), influence.joints.begin(), influence.joints.end());
      weights_.insert(weights_.end(), influence.weights.begin(), influence.weights.end());
    }
    for (const std::uint32_t corner : {0U, 1U, 3U, 0U, 3U, 2U}) indices_.push_back(first + corner);
  }
}

CrowdMeshData Doll::mesh_data() const {
  CrowdMeshData data;
  MeshPartData part;
  part.positions = {&positions_[0].x, positions_.size() * 3};
  part.normals = {&normals_[0].x, normals_.size() * 3};
  part.regions = regions_;
  part.palette_entries = joints_;
  part.weights = weights_;
  part.indices = indices_;
  data.parts = {part};
  data.materials = {MaterialData{}};
  data.entry_at_level = {{hips, chest, head, left_arm, right_arm, legs}, {hips, chest, chest, chest, chest, legs}};
  data.bone_ends = {{{0.0F, 1.4F, 0.0F}, chest}, {{0.0F, 0.9F, 0.0F}, hips}};
  return data;
}

glm::dmat4 Doll::blended(std::size_t vertex, const DollPalette& palette) const {
  glm::dmat4 sum(0.0);
  for (std::size_t i = vertex * 4; i < vertex * 4 + 4; ++i) {
    sum += matrix_of(palette[joints_[i]]) * static_cast<double>(weights_[i]);
  }
  return sum;
}

glm::dvec3 Doll::skinned_position(std::size_t vertex, const DollPalette& palette) const {
  return {blended(vertex, palette) * glm::dvec4(positions_[vertex], 1.0)};
}

glm::dvec3 Doll::skinned_normal(std::size_t vertex, const DollPalette& palette) const {
  return glm::dmat3(blended(vertex, palette)) * glm::dvec3(normals_[vertex]);
}

DollPalette doll_pose(float bend) {
  const glm::vec3 forwards{1.0F, 0.0F, 0.0F}, sideways{0.0F, 0.0F, 1.0F}, about{0.0F, 1.0F, 0.0F};
  const glm::mat4 at_hips = turned_about({0.0F, 0.9F, 0.0F}, 0.1F * bend, about);
  const glm::mat4 at_chest = at_hips * turned_about({0.0F, 1.1F, 0.0F}, 0.3F * bend, forwards);
  const glm::mat4 at_head = at_chest * turned_about({0.0F, 1.45F, 0.0F}, -0.4F * bend, about);
  const glm::mat4 at_left = at_chest * turned_about({0.22F, 1.38F, 0.0F}, 1.2F * bend, sideways);
  const glm::mat4 at_right = at_chest * turned_about({-0.22F, 1.38F, 0.0F}, -0.9F * bend, sideways);
  const glm::mat4 at_legs = turned_about({0.0F, 0.9F, 0.0F}, -0.05F * bend, forwards);
  return {rows_of(at_hips), rows_of(at_chest), rows_of(at_head), rows_of(at_left), rows_of(at_right), rows_of(at_legs)};
}

}  // namespace throng::render::test
