#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace throng::render {

/// Four influences of a point of a skinned surface.
struct SkinInfluences {
  std::array<std::uint16_t, 4> entries;
  std::array<float, 4> weights;
};

/// What it costs to move a piece of surface to another of its points: how far it would lie from its planes (Garland and
/// Heckbert, "Surface Simplification Using Quadric Error Metrics", 1997), and how differently joints would move it. The
/// second term is what keeps a ring of vertices around each elbow and knee.
class CollapseCost {
 public:
  /// A triangle's share: its plane (unit normal, through `point`) and its influences there, weighted by area.
  void add_plane(const glm::dvec3& normal, const glm::dvec3& point, double area);
  void add_influences(const SkinInfluences& influences, double area);
  void add(const CollapseCost& other);

  /// Mean squared distance from the planes at `point`, square metres.
  double squared_distance(const glm::dvec3& point) const;

  /// Cost of having all of the piece at `point`, moved by `influences`: square metres times area. A joint that moves
  /// one part of the surface and not the other counts as `joint_travel` metres.
  double at(const glm::dvec3& point, const SkinInfluences& influences, double joint_travel) const;

 private:
  double plane_cost(const glm::dvec3& point) const;
  double influence_cost(const SkinInfluences& influences) const;

  // Sum of area * (n n^T, n d, d d) over the planes n . p + d = 0.
  std::array<double, 6> matrix_{};  // xx xy xz yy yz zz
  glm::dvec3 vector_{0.0};
  double scalar_ = 0.0;
  double plane_area_ = 0.0;

  // Sum of area * weight a palette entry, ascending; and of area * weight^2 over all.
  std::vector<std::pair<std::uint16_t, double>> weight_sums_;
  double squared_weights_ = 0.0;
  double influence_area_ = 0.0;
};

}  // namespace throng::render
