#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/sampled_stream.h"
#include "engine/anim/bake/grid.h"
#include "engine/anim/bake/rounding.h"
#include "engine/anim/bake/surface.h"

namespace throng::anim {

/// The input of a sampled stream, and the bound on its error.
struct SampleSource {
  const Skeleton& skeleton;
  const SurfaceProxy& proxy;
  const KeyframeStream& exact;
  glm::dvec3 travel{0.0};  ///< root motion taken out of `exact`; it goes on before and after the clip's keys
  double error_bound = 0.0;
  std::span<const Ticks> steps{};  ///< times at which a STEP track of `exact` jumps
};

struct SampledBake {
  AlignedBytes block;  ///< null if no rate keeps to the bound, or the clip is too long for any
  double rate = 0.0;   ///< Hz
  double error = 0.0;  ///< metres; without a block at most that of the best rate, infinite if none was tried
  Rounding rounding = Rounding::nearest;
};

inline constexpr double finest_sample_rate = 2.0 * highest_sample_rate;

/// Tries the grid's own rate and its multiples up to finest_sample_rate, lowest first, until the error on the rows and
/// between them is within the bound. The clip does not move after `last_key`.
SampledBake bake_sampled(const SampleSource& source, const KeyGrid& grid, Ticks last_key);

/// Makes the stream of a clip in which nothing moves: one row.
SampledBake bake_still(const SampleSource& source);

/// Samples the source at the times of the rows of `stream`, which was made of the same clip on a skeleton whose bones
/// have other places. A packet without motion keeps floats where others have int16, so lanes cannot change packets.
AlignedBytes sample_as(const SampleSource& source, const SampledStream& stream, Rounding rounding);

/// Returns the largest distance on the proxy between the two streams: on every row, at several times between rows, many
/// around the worst, and on both sides of every step. It counts what the rounding of times between rows may add. Stops
/// early, with what it has found, where that is many times the bound.
double measure_error(const SampleSource& source, const SampledStream& stream);

}  // namespace throng::anim
