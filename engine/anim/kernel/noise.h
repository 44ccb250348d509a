#pragma once

#include <cstdint>

#include "engine/anim/base/units.h"
#include "engine/anim/kernel/pose.h"

namespace throng::anim {

/// Where a time lies between the lattice points of noise.
struct NoisePoint {
  std::int64_t lattice = 0;
  float fraction = 0.0F;  ///< 0 to 1
};

/// `frequency` lattice points a second, 0 or more. Whole seconds and the rest are kept apart, so the fraction is as
/// exact after years as it is at first. Negative times are as good as others.
NoisePoint noise_at(Ticks time, float frequency);

/// Noise: turns bones a little, out = from * rotation, smoothly (its velocity has no jumps) and always the same at the
/// same time. Each axis of each bone has a value from -1 to 1 at every lattice point, ten bits of an integer hash of
/// seed, bone and point; between them runs a uniform quadratic B-spline. A bone of amplitude 0 keeps its bits. `out`
/// may be `from`.
struct NoiseJob {
  const float* from = nullptr;        ///< [components][16]
  const float* amplitudes = nullptr;  ///< [16], rad, 0 to pi: no turn is ever larger; 0 at and above the bone count
  NoisePoint point;
  std::uint64_t seed = 0;
  int packet = 0;  ///< which 16 bones these are
  int components = rigid_components;
  float* out = nullptr;  ///< [components][16]
};

}  // namespace throng::anim
