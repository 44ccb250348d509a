#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/render/mesh/collapse_cost.h"

namespace throng::render {

/// Describes a skinned triangle mesh that is to be simplified. Vertices at the same position are one point of the
/// surface; they differ in normal, texture coordinates, material or region.
struct SkinnedSurfaceView {
  std::span<const float> positions;            ///< x y z a vertex
  std::span<const SkinInfluences> influences;  ///< one a vertex
  std::span<const std::uint32_t> belongs_to;   ///< material and tint region, one a vertex; their borders stay sharp
  std::span<const std::uint32_t> indices;
  std::span<const float> texture_coords;    ///< u v a vertex, or empty if there is no texture
  std::span<const glm::vec3> colors = {};   ///< one a vertex, as seen (PointLook::color), or empty: all alike
  std::span<const std::uint8_t> face = {};  ///< one a vertex, 1 on a face, or empty: no face is known
  double face_firmness = 25.0;              ///< an error on a face counts as one of a surface this many times as large
  double open_edge_firmness = 4.0;          ///< an open edge is held this many times as firmly as a surface of its size
};

/// Merges points of a skinned surface along its edges, the cheapest first (CollapseCost).
/// A point is always merged into another point of the surface, so that weights stay valid.
/// Colours stay where they are as far as they can, and faces are held more firmly than all else.
/// Triangles never turn over. Borders between materials and regions stay where they are.
class SurfaceSimplifier {
 public:
  explicit SurfaceSimplifier(const SkinnedSurfaceView& surface);

  /// Merges until at most `triangles` are left, the next merge would move the surface by more than `largest_error`
  /// metres, or nothing more can be merged.
  void reduce_to(std::size_t triangles, double largest_error);

  std::size_t triangle_count() const { return triangle_count_; }
  std::vector<std::uint32_t> indices() const;  ///< of original vertices
  double error() const { return error_; }      ///< metres, the largest distance moved so far

 private:
  using Triangle = std::array<std::uint32_t, 3>;         // vertices
  using Edge = std::pair<std::uint32_t, std::uint32_t>;  // points, ascending

  struct Point {
    glm::dvec3 position;
    SkinInfluences influences;
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> triangles;
    CollapseCost cost;
    std::uint32_t version = 0;
    bool merged_away = false;
  };

  /// Would move point `from` to point `into`.
  struct Merge {
    double cost;
    std::uint32_t from;
    std::uint32_t into;
    std::uint32_t version;  // of `from`, when the cost was computed
    bool operator>(const Merge& other) const { return cost > other.cost; }
  };

  /// Pairs each vertex of the point that goes with the vertex of the other point that stands in for it.
  using StandIns = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

  void join_vertices_into_points();
  void add_triangles();
  void hold_open_edges();
  Edge edge_of(const Triangle& triangle, std::size_t corner) const;
  double firmness(std::uint32_t vertex) const;
  void propose_merges_around(std::uint32_t point);
  double color_cost(const Point& from, const Point& into) const;
  bool is_current(const Merge& merge) const;
  bool pinches(std::uint32_t from, std::uint32_t into) const;
  bool turns_a_triangle_over(std::uint32_t from, std::uint32_t into) const;
  bool find_stand_ins(std::uint32_t from, std::uint32_t into, StandIns& stand_ins) const;
  std::uint32_t stand_in_elsewhere(std::uint32_t vertex, const Point& into) const;
  bool looks_like(std::uint32_t vertex, std::uint32_t other) const;
  void merge(std::uint32_t from, std::uint32_t into, const StandIns& stand_ins);

  bool has_point(const Triangle& triangle, std::uint32_t point) const;
  std::vector<std::uint32_t> neighbours(std::uint32_t point) const;
  glm::dvec3 normal(const Triangle& triangle) const;  // twice the area long

  SkinnedSurfaceView surface_;
  std::vector<std::uint32_t> point_of_vertex_;
  std::vector<ColorSpread> painted_;  // [vertex]; empty: no colours are known
  std::vector<Point> points_;
  std::vector<Triangle> triangles_;
  std::vector<bool> removed_;  // one a triangle
  std::size_t triangle_count_ = 0;
  double joint_travel_ = 0.0;
  double color_travel_ = 0.0;
  double error_ = 0.0;
  std::priority_queue<Merge, std::vector<Merge>, std::greater<>> merges_;
};

}  // namespace throng::render
