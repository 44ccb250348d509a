#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace throng::render {

/// A piece of a triangle that is small enough to have one colour. Its corners are weights of the triangle's vertices.
struct SurfaceCell {
  std::array<glm::vec3, 3> corners;  ///< positions
  std::array<glm::vec3, 3> weights;  ///< of the triangle's vertices
  std::uint32_t triangle = 0;
  bool hides = true;  ///< false: it is seen through
};

/// Cuts triangles into cells whose edges are at most `longest_edge`, in metres.
/// `positions` has one element a vertex, `indices` three a triangle. Triangles without area have no cell.
std::vector<SurfaceCell> cut_into_cells(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                        float longest_edge);

/// Returns the weights of a cell's corners at the point of the cell that is closest to `point`.
glm::vec3 closest_weights(const SurfaceCell& cell, const glm::vec3& point);

/// Returns whether the ray meets the cell.
bool is_hit(const SurfaceCell& cell, const glm::vec3& from, const glm::vec3& direction);

inline glm::vec3 position_in(const SurfaceCell& cell, const glm::vec3& weights) {
  return cell.corners[0] * weights.x + cell.corners[1] * weights.y + cell.corners[2] * weights.z;
}

/// Finds the closest cells of a surface, and the cells that a ray meets.
class CellTree {
 public:
  /// A point of a cell: `weights` are of the cell's corners.
  struct Found {
    const SurfaceCell* cell = nullptr;  ///< null: no point is below the limit
    glm::vec3 weights{0.0F};
    float distance = std::numeric_limits<float>::infinity();
  };

  explicit CellTree(std::vector<SurfaceCell> cells);

  std::span<const SurfaceCell> cells() const { return cells_; }

  /// Returns the point of the smallest `measure(cell, weights, below)` that is below `limit`.
  /// `measure` gets the point of a cell that is closest to `point` and may move its weights. It returns at least the
  /// distance to `point`, or infinity for a point that is not allowed. A result of `below` or more is not used, so it
  /// may stop there.
  template <typename Measure>
  Found closest(const glm::vec3& point, float limit, const Measure& measure) const;

  /// Returns whether a ray meets a cell that hides. No component of `direction` is 0.
  bool meets_a_cell(const glm::vec3& from, const glm::vec3& direction) const;

 private:
  // A node holds either two nodes, the first of which follows it, or cells.
  struct Node {
    glm::vec3 low, high;
    std::uint32_t second = 0;  // node; 0: this one holds cells
    std::uint32_t first_cell = 0, cell_count = 0;
  };
  static constexpr std::uint32_t most_cells = 8;  // of a node
  static constexpr std::size_t deepest = 64;

  void build(std::uint32_t first, std::uint32_t count);
  static bool is_crossed(const Node& node, const glm::vec3& from, const glm::vec3& inverse_direction);
  static float distance_to(const Node& node, const glm::vec3& point);

  std::vector<SurfaceCell> cells_;
  std::vector<Node> nodes_;
};

template <typename Measure>
CellTree::Found CellTree::closest(const glm::vec3& point, float limit, const Measure& measure) const {
  Found found;
  found.distance = limit;
  if (nodes_.empty()) return found;
  std::array<std::uint32_t, deepest> waiting{};
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t index = waiting[--count];
    const Node& node = nodes_[index];
    if (distance_to(node, point) >= found.distance) continue;
    if (node.second != 0) {
      const bool first_is_nearer = distance_to(nodes_[index + 1], point) < distance_to(nodes_[node.second], point);
      waiting[count++] = first_is_nearer ? node.second : index + 1;
      waiting[count++] = first_is_nearer ? index + 1 : node.second;
      continue;
    }
    for (const SurfaceCell& cell : std::span(cells_).subspan(node.first_cell, node.cell_count)) {
      glm::vec3 weights = closest_weights(cell, point);
      if (glm::distance(position_in(cell, weights), point) >= found.distance) continue;
      const float distance = measure(cell, weights, found.distance);
      if (distance < found.distance) found = {&cell, weights, distance};
    }
  }
  return found;
}

}  // namespace throng::render
