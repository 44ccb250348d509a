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

/// All gaits of a character, in the plane of its velocity. It tells by which of them somebody moves, and how fast the
/// legs go.
///
/// People who slow down shorten their steps and take fewer of them, both by the root of the speed (the walk ratio; N.
/// Sekiya and H. Nagasaki, "Reproducibility of the walking patterns of normal young adults", Gait & Posture 7, 1998).
/// So somebody slower than the slowest gait moves by more of it than the share of the speed would be.
class StridePlane {
 public:
  /// `points` has at least one, the middle first, whose velocity is 0 (gait_points). None has the velocity of another.
  explicit StridePlane(std::vector<StridePoint> points);

  struct Stride {
    anim::BlendPlane::Shares shares;
    double cycles_per_second = 0.0;
    float stands = 1.0F;  ///< the share of standing still over what the other shares are: 1 at rest, 0 from a slow walk
  };
  /// `velocity`: metres a second at scale 1, aside and ahead.
  Stride stride(const glm::vec2& velocity) const;

  std::span<const StridePoint> points() const { return points_; }
  /// Returns the gait by whose stride cycles are counted: the first that moves; 0 where nobody does.
  std::size_t reference() const { return points_.size() > 1 ? 1 : 0; }

 private:
  float slowest(const glm::vec2& direction) const;

  std::vector<StridePoint> points_;
  anim::BlendPlane plane_;
  float slowest_ahead_ = 0.0F, slowest_back_ = 0.0F, slowest_aside_ = 0.0F;
};

}  // namespace throng::app
