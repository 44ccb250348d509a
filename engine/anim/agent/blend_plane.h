#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "engine/base/result.h"

namespace throng::anim {

/// Points in a plane, joined to triangles that overlap nowhere and are as round as can be (Delaunay, "Sur la sphère
/// vide", 1934; made by a sweep and the edge flips of Lawson, 1977). It shares a place out among the corners of the
/// triangle that holds it. Read-only once made, so any number of agents may use one.
class BlendPlane {
 public:
  static constexpr std::size_t most_points = 64;

  struct Share {
    std::size_t point = 0;
    float weight = 0.0F;  ///< above 0
  };
  struct Shares {
    std::array<Share, 3> of{};  ///< ascending by point; the weights add up to 1
    std::size_t count = 0;      ///< 1 to 3
    glm::vec2 place{0.0F};      ///< the place that they stand for: the requested place, or the nearest in the hull

    std::span<const Share> all() const& { return {of.data(), count}; }
    std::span<const Share> all() && = delete;  ///< a loop over them would outlive them
  };

  /// Takes 1 to `most_points` points. Points on a line, or fewer than three, work as a line or a point. Errors: there
  /// is no point or too many, a coordinate is not finite, or two points lie at one place.
  static Result<BlendPlane> create(std::span<const glm::vec2> points);

  /// `place` is finite.
  Shares shares(const glm::vec2& place) const;

  std::span<const glm::vec2> points() const { return points_; }
  std::span<const std::array<std::size_t, 3>> triangles() const { return triangles_; }  ///< counter-clockwise

 private:
  BlendPlane() = default;

  std::vector<glm::vec2> points_;
  std::vector<std::array<std::size_t, 3>> triangles_;
  std::vector<std::array<std::size_t, 2>> edges_;  // of the hull, or the line
};

}  // namespace throng::anim
