#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "app/people/crowd/numbers/turn.h"

namespace throng::app {

/// A convex polygon on the ground that is cut smaller and smaller, without memory of its own to take.
class ConvexPolygon {
 public:
  explicit ConvexPolygon(std::span<const glm::vec2> corners) {
    count_ = corners.size() < most_corners ? corners.size() : most_corners;
    std::copy_n(corners.begin(), count_, corners_.begin());
  }
  ConvexPolygon(const ConvexPolygon& other) : ConvexPolygon(other.corners()) {}
  ConvexPolygon& operator=(const ConvexPolygon&) = delete;

  std::span<const glm::vec2> corners() const { return std::span(corners_).first(count_); }
  bool is_empty() const { return count_ < 3; }

  /// Keeps the part where dot(normal, place) is at most `most`. A cut that would take one corner too many is left out.
  void cut(const glm::vec2& normal, float most) {
    std::array<float, most_corners> beyond;
    bool is_cut = false;
    for (std::size_t i = 0; i < count_; ++i) {
      beyond[i] = glm::dot(normal, corners_[i]) - most;
      is_cut |= beyond[i] > 0.0F;
    }
    if (!is_cut || count_ == most_corners) return;
    std::array<glm::vec2, most_corners> before;
    const std::size_t count = count_;
    std::copy_n(corners_.begin(), count, before.begin());
    count_ = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = i + 1 < count ? i + 1 : 0;
      if (beyond[i] <= 0.0F) corners_[count_++] = before[i];
      if ((beyond[i] > 0.0F) == (beyond[next] > 0.0F)) continue;
      corners_[count_++] = before[i] + (beyond[i] / (beyond[i] - beyond[next])) * (before[next] - before[i]);
    }
  }

  /// Returns square metres.
  float area() const {
    float twice = 0.0F;
    for (std::size_t i = 2; i < count_; ++i) {
      twice += cross(corners_[i - 1] - corners_[0], corners_[i] - corners_[0]);
    }
    return 0.5F * (twice < 0.0F ? -twice : twice);
  }

  /// Returns the square of the distance from the origin to the farthest corner.
  float reach_squared() const {
    float most = 0.0F;
    for (std::size_t i = 0; i < count_; ++i) {
      const float squared = glm::dot(corners_[i], corners_[i]);
      if (squared > most) most = squared;
    }
    return most;
  }

 private:
  static constexpr std::size_t most_corners = 96;

  std::array<glm::vec2, most_corners> corners_;
  std::size_t count_ = 0;
};

}  // namespace throng::app
