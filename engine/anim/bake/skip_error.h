#pragma once

#include <array>
#include <cstddef>

#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

struct BakedClip;
struct SurfaceProxy;

/// The error of a clip's surface when only some of its frames are posed, in metres. 99% of the clip's frames stay below
/// it at their worst point. `spans` are the times between posed frames, in sixtieths of a second.
struct SkipError {
  static constexpr std::array<int, 4> spans{2, 4, 8, 16};

  /// The error if skipped frames lie on the straight line between two posed ones (smooth skipping). It grows about as
  /// the square of the span. It is a walking person's until it is measured.
  std::array<float, spans.size()> blended{0.0018F, 0.007F, 0.028F, 0.1F};
  /// The error if skipped frames show the last posed one.
  std::array<float, spans.size()> held{0.03F, 0.088F, 0.18F, 0.3F};

  /// Returns the error at any span, along power laws between the measured ones; 0 at one sixtieth or less.
  float metres(float sixtieths, bool smooth) const;
};

/// The error of a clip in which nothing moves.
inline constexpr SkipError no_skip_error{.blended = {}, .held = {}};

/// Measures a clip on the points of `proxy`, without root motion, in stretches all over the clip. A character with more
/// `clips` gets fewer stretches a clip.
SkipError measure_skip_error(const Skeleton& skeleton, const SurfaceProxy& proxy, const BakedClip& clip,
                             std::size_t clips);

}  // namespace throng::anim
