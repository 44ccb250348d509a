#pragma once

#include <string>

#include <glm/vec3.hpp>

#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/sampled_stream.h"
#include "engine/anim/bake/grid.h"
#include "engine/anim/bake/surface.h"

namespace throng::anim {

/// The input of a sampled stream, and the bound on its error.
struct SampleSource {
  const Skeleton& skeleton;
  const SurfaceProxy& proxy;
  const KeyframeStream& exact;
  glm::dvec3 travel{0.0};  ///< root motion taken out of `exact`; it goes on before and after the clip's keys
  double error_bound = 0.0;
};

struct SampledBake {
  AlignedBytes block;  ///< null if the clip is too long for any rate
  double rate = 0.0;
  double error = 0.0;
};

/// Tries the grid's own rate and its multiples up to highest_sample_rate, lowest first, until the error on the rows and
/// between them is within the bound. If none is, takes the lowest rate of about the least error. The clip does not move
/// after `last_key`.
SampledBake bake_sampled(const SampleSource& source, const KeyGrid& grid, Ticks last_key);

/// Makes the stream of a clip in which nothing moves: one row.
SampledBake bake_still(const SampleSource& source);

/// Samples the source at the times of the rows of `stream`, which was made of the same clip on a skeleton whose bones
/// have other places. A packet without motion keeps floats where others have int16, so lanes cannot change packets.
AlignedBytes sample_as(const SampleSource& source, const SampledStream& stream);

/// Returns the largest distance on the proxy between the two streams, on every row and at several times between rows.
double measure_error(const SampleSource& source, const SampledStream& stream);

}  // namespace throng::anim
