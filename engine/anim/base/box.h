#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace throng::anim {

/// The least box along the axes that holds its points. It has none at first.
struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  bool is_empty() const { return !(low.x <= high.x); }
  glm::dvec3 size() const { return high - low; }
  glm::dvec3 middle() const { return (low + high) * 0.5; }
};

}  // namespace throng::anim
