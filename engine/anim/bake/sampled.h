#pragma once

#include <string>

#include <glm/vec3.hpp>

#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/sampled_stream.h"
#include "engine/anim/bake/grid.h"
#include "engine/anim/bake/surface.h"

namespace throng::anim {

/// What a sampled stream is made from, and what it is held to.
struct SampleSource {
  const Skeleton& skeleton;
  const SurfaceProxy& proxy;
  const KeyframeStream& exact;
  glm::dvec3 travel{0.0};  ///< root motion that was taken out of `exact`: it goes on before and after the clip's keys
  double error_bound = 0.0;
};

struct SampledBake {
  AlignedBytes block;  ///< null if the clip is too long for any rate
  double rate = 0.0;
  double error = 0.0;
};

/// Tries the grid's own rate and its multiples up to highest_sample_rate, lowest first, until the error measured
/// between and on the rows is within the bound; where none is, the lowest rate of about the least error is taken.
/// `last_key`: the clip does not move after it.
SampledBake bake_sampled(const SampleSource& source, const KeyGrid& grid, Ticks last_key);

/// The stream of a clip in which nothing moves: one row.
SampledBake bake_still(const SampleSource& source);

/// Largest distance on the proxy between the two streams, on every row and at several times between rows.
double measure_error(const SampleSource& source, const SampledStream& stream);

}  // namespace throng::anim
