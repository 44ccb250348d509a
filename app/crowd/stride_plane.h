#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "engine/anim/agent/blend_plane.h"

namespace throng::app {

/// A gait of a character, or the way that it stands or steps on the spot.
struct StridePoint {
  int clip = 0;
  glm::vec2 velocity{0.0F};  ///< metres a second at scale 1, aside (to the left) and ahead; 0: it stands
  double seconds = 1.0;      ///< of the clip, which is one stride: a left and a right step
};

/// All gaits of a character, in the plane of its velocity. It tells by which of them somebody moves, and how fast the
/// legs go.
///
/// People who slow down shorten their steps and take fewer of them, both by the root of the speed (the walk ratio; N.
/// Sekiya and H. Nagasaki, "Reproducibility of the walking patterns of normal young adults", Gait & Posture 7, 1998).
/// So somebody slower than the slowest gait moves by more of it than the share of the speed would be.
class StridePlane {
 public:
  /// How somebody is in the middle of the plane: stands, or steps on the spot, so that slow people lift their feet.
  enum class Middle : unsigned char { stands, steps };

  /// `points` has at least one, the middle first, whose velocity is 0. None has the velocity of another.
  StridePlane(std::vector<StridePoint> points, Middle middle);

  struct Stride {
    anim::BlendPlane::Shares shares;
    double cycles_per_second = 0.0;
    float stands = 1.0F;  ///< the share of standing still over what the other shares are: 1 at rest, 0 from a slow walk
  };
  /// `velocity`: metres a second at scale 1, aside and ahead.
  Stride stride(const glm::vec2& velocity) const;

  std::span<const StridePoint> points() const { return points_; }
  /// Returns whether a point has feet that come down.
  bool is_gait(std::size_t point) const { return point > 0 || middle_ == Middle::steps; }
  /// Returns the gait by whose stride cycles are counted: the first that moves; 0 where nobody does.
  std::size_t reference() const { return points_.size() > 1 ? 1 : 0; }

 private:
  float slowest(const glm::vec2& direction) const;

  std::vector<StridePoint> points_;
  Middle middle_;
  anim::BlendPlane plane_;
  float slowest_ahead_ = 0.0F, slowest_back_ = 0.0F, slowest_aside_ = 0.0F;
};

}  // namespace throng::app
