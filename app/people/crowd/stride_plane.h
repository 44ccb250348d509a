#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "app/character/gait_plane.h"
#include "engine/anim/agent/blend_plane.h"

namespace throng::app {

/// A gait of a character, or how it stands, with the length of its clip.
struct StridePoint {
  GaitPoint gait = {};
  double seconds = 1.0;  ///< of the clip, which is one stride: a left and a right step
};

/// All gaits of a character, in the plane of its velocity. It tells which of them an agent plays, and how fast the legs
/// go.
///
/// People who slow down shorten their steps and take fewer of them, both by the root of the speed (the walk ratio; N.
/// Sekiya and H. Nagasaki, "Reproducibility of the walking patterns of normal young adults", Gait & Posture 7, 1998).
/// So an agent at half the speed of its slowest gait plays more than half of that gait.
class StridePlane {
 public:
  /// `points` has at least one, the middle first, whose velocity is 0 (gait_points). No two have equal velocities.
  explicit StridePlane(std::vector<StridePoint> points);

  struct Stride {
    anim::BlendPlane::Shares shares;
    double cycles_per_second = 0.0;
    float stands = 1.0F;  ///< weight of standing still over the other shares: 1 at rest, 0 from a slow walk
  };
  /// `velocity`: metres a second at scale 1, aside and ahead.
  Stride stride(const glm::vec2& velocity) const;

  std::span<const StridePoint> points() const { return points_; }
  /// Returns the gait by whose stride cycles are counted: the first that moves; 0 where none does.
  std::size_t reference() const { return points_.size() > 1 ? 1 : 0; }

 private:
  float slowest(const glm::vec2& direction) const;

  std::vector<StridePoint> points_;
  anim::BlendPlane plane_;
  float slowest_ahead_ = 0.0F, slowest_back_ = 0.0F, slowest_aside_ = 0.0F;
};

}  // namespace throng::app
