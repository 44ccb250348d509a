#include "engine/render/mesh/cell_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

namespace throng::render {
namespace {

constexpr int most_halvings = 16;  // of a triangle

float squared_length(const glm::vec3& edge) { return glm::dot(edge, edge); }

/// Halves the longest edge until all are short enough.
void cut(const SurfaceCell& cell, float squared_edge, int halvings, std::vector<SurfaceCell>& cells) {
  std::size_t longest = 0;
  std::array<float, 3> squares{};
  for (std::size_t i = 0; i < 3; ++i) {
    squares.at(i) = squared_length(cell.corners.at((i + 1) % 3) - cell.corners.at(i));
    if (squares.at(i) > squares.at(longest)) longest = i;
  }
  if (squares.at(longest) <= squared_edge || halvings == 0) {
    cells.push_back(cell);
    return;
  }
  const std::size_t next = (longest + 1) % 3;
  SurfaceCell first = cell, second = cell;
  first.corners.at(next) = second.corners.at(longest) = 0.5F * (cell.corners.at(longest) + cell.corners.at(next));
  first.weights.at(next) = second.weights.at(longest) = 0.5F * (cell.weights.at(longest) + cell.weights.at(next));
  cut(first, squared_edge, halvings - 1, cells);
  cut(second, squared_edge, halvings - 1, cells);
}

glm::vec3 middle_of(const SurfaceCell& cell) {
  return (cell.corners[0] + cell.corners[1] + cell.corners[2]) * (1.0F / 3.0F);
}

}  // namespace

std::vector<SurfaceCell> cut_into_cells(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                        float longest_edge) {
  std::vector<SurfaceCell> cells;
  for (std::size_t first = 0; first + 2 < indices.size(); first += 3) {
    SurfaceCell whole{.corners = {},
                      .weights = {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)},
                      .triangle = static_cast<std::uint32_t>(first / 3)};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      whole.corners.at(corner) = positions[indices[first + corner]];
    }
    const glm::vec3 twice_area = glm::cross(whole.corners[1] - whole.corners[0], whole.corners[2] - whole.corners[0]);
    if (squared_length(twice_area) > 0.0F) cut(whole, longest_edge * longest_edge, most_halvings, cells);
  }
  return cells;
}

// Ericson, "Real-Time Collision Detection", 5.1.5: the corner, edge or inside whose region the point is in.
glm::vec3 closest_weights(const SurfaceCell& cell, const glm::vec3& point) {
  const auto& [a, b, c] = cell.corners;
  const glm::vec3 ab = b - a, ac = c - a;
  const float d1 = glm::dot(ab, point - a), d2 = glm::dot(ac, point - a);
  if (d1 <= 0.0F && d2 <= 0.0F) return {1, 0, 0};
  const float d3 = glm::dot(ab, point - b), d4 = glm::dot(ac, point - b);
  if (d3 >= 0.0F && d4 <= d3) return {0, 1, 0};
  const float d5 = glm::dot(ab, point - c), d6 = glm::dot(ac, point - c);
  if (d6 >= 0.0F && d5 <= d6) return {0, 0, 1};
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0F && d1 >= 0.0F && d3 <= 0.0F) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0F && d2 >= 0.0F && d6 <= 0.0F) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0.0F && d4 - d3 >= 0.0F && d5 - d6 >= 0.0F) {
    const float share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - share, share};
  }
  const float sum = va + vb + vc;
  if (!(sum > 0.0F)) return {1, 0, 0};  // a cell without area
  return {1 - (vb + vc) / sum, vb / sum, vc / sum};
}

// Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
bool is_hit(const SurfaceCell& cell, const glm::vec3& from, const glm::vec3& direction) {
  const glm::vec3 ab = cell.corners[1] - cell.corners[0], ac = cell.corners[2] - cell.corners[0];
  const glm::vec3 p = glm::cross(direction, ac);
  const float determinant = glm::dot(ab, p);
  if (determinant == 0.0F) return false;
  const glm::vec3 t = from - cell.corners[0];
  const float u = glm::dot(t, p) / determinant;
  if (u < 0.0F || u > 1.0F) return false;
  const glm::vec3 q = glm::cross(t, ab);
  const float v = glm::dot(direction, q) / determinant;
  return v >= 0.0F && u + v <= 1.0F && glm::dot(ac, q) / determinant > 0.0F;
}

CellTree::CellTree(std::vector<SurfaceCell> cells) : cells_(std::move(cells)) {
  nodes_.reserve(cells_.size() / 2 + 1);
  if (!cells_.empty()) build(0, static_cast<std::uint32_t>(cells_.size()));
}

void CellTree::build(std::uint32_t first, std::uint32_t count) {
  const auto index = nodes_.size();
  Node node{.low = glm::vec3(INFINITY), .high = glm::vec3(-INFINITY), .first_cell = first, .cell_count = count};
  const std::span cells = std::span(cells_).subspan(first, count);
  for (const SurfaceCell& cell : cells) {
    for (const glm::vec3& corner : cell.corners) {
      node.low = glm::min(node.low, corner);
      node.high = glm::max(node.high, corner);
    }
  }
  nodes_.push_back(node);
  if (count <= most_cells) return;
  const glm::vec3 extent = node.high - node.low;
  const glm::length_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const std::uint32_t half = count / 2;
  std::nth_element(cells.begin(), cells.begin() + half, cells.end(), [axis](const auto& one, const auto& other) {
    return middle_of(one)[axis] < middle_of(other)[axis];
  });
  build(first, half);
  nodes_[index].second = static_cast<std::uint32_t>(nodes_.size());
  build(first + half, count - half);
}

bool CellTree::is_crossed(const Node& node, const glm::vec3& from, const glm::vec3& inverse_direction) {
  const glm::vec3 a = (node.low - from) * inverse_direction, b = (node.high - from) * inverse_direction;
  const glm::vec3 in = glm::min(a, b), out = glm::max(a, b);
  return std::max({in.x, in.y, in.z, 0.0F}) <= std::min({out.x, out.y, out.z});
}

bool CellTree::meets_a_cell(const glm::vec3& from, const glm::vec3& direction) const {
  if (nodes_.empty()) return false;
  const glm::vec3 inverse_direction = 1.0F / direction;
  std::array<std::uint32_t, deepest> waiting{};
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t index = waiting[--count];
    const Node& node = nodes_[index];
    if (!is_crossed(node, from, inverse_direction)) continue;
    if (node.second != 0) {
      waiting[count++] = node.second;
      waiting[count++] = index + 1;
      continue;
    }
    const std::span cells = std::span(cells_).subspan(node.first_cell, node.cell_count);
    const auto stops = [&](const SurfaceCell& cell) { return cell.hides && is_hit(cell, from, direction); };
    if (std::ranges::any_of(cells, stops)) return true;
  }
  return false;
}

float CellTree::distance_to(const Node& node, const glm::vec3& point) {
  return glm::distance(point, glm::clamp(point, node.low, node.high));
}

}  // namespace throng::render
