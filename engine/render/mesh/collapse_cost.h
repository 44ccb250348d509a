#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace throng::render {

/// Four influences of a point of a skinned surface.
struct SkinInfluences {
  std::array<std::uint16_t, 4> entries;
  std::array<float, 4> weights;
};

/// Returns the cost of moving a piece of surface to another of its points. One term counts how far the piece would lie
/// from its planes (Garland and Heckbert, "Surface Simplification Using Quadric Error Metrics", 1997). The other counts
/// how differently joints would move it, which keeps a ring of vertices around each elbow and knee.
class CollapseCost {
 public:
  /// These two functions add the share of a triangle, weighted by `area`: its plane, which has a unit normal and goes
  /// through `point`, and its influences there.
  void add_plane(const glm::dvec3& normal, const glm::dvec3& point, double area);
  void add_influences(const SkinInfluences& influences, double area);
  void add(const CollapseCost& other);

  /// Gives the mean squared distance of `point` from the planes, in square metres.
  double squared_distance(const glm::dvec3& point) const;

  /// Gives the cost of having the whole piece at `point`, moved by `influences`, in square metres times area. A joint
  /// that moves one part of the surface and not the other counts as `joint_travel` metres.
  double at(const glm::dvec3& point, const SkinInfluences& influences, double joint_travel) const;

 private:
  double plane_cost(const glm::dvec3& point) const;
  double influence_cost(const SkinInfluences& influences) const;

  // Sum of area * (n n^T, n d, d d) over the planes n . p + d = 0.
  std::array<double, 6> matrix_{};  // xx xy xz yy yz zz
  glm::dvec3 vector_{0.0};
  double scalar_ = 0.0;
  double plane_area_ = 0.0;

  // Sums of area * weight by palette entry, which ascend, and of area * weight^2 over all entries.
  std::vector<std::pair<std::uint16_t, double>> weight_sums_;
  double squared_weights_ = 0.0;
  double influence_area_ = 0.0;
};

/// Returns the cost of painting a piece of surface in one colour: how far its own colours are from that one.
class ColorSpread {
 public:
  /// Adds the share of a triangle. Colours are as they are seen (PointLook::color).
  void add(const glm::dvec3& color, double area);
  void add(const ColorSpread& other);

  /// Gives the sum of area times the squared distance from `color`.
  double at(const glm::dvec3& color) const;

 private:
  glm::dvec3 sum_{0.0};
  double squares_ = 0.0;
  double area_ = 0.0;
};

}  // namespace throng::render
