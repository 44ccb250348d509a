#pragma once

#include "engine/anim/asset/sampled_stream.h"
#include "engine/anim/bake/grid.h"
#include "engine/anim/bake/rounding.h"
#include "engine/anim/bake/sample_source.h"

namespace throng::anim {

struct SampledBake {
  AlignedBytes block;  ///< null if no rate keeps to the bound, or the clip is too long for any
  double rate = 0.0;   ///< Hz
  double error = 0.0;  ///< metres; without a block at most the best rate's, infinite if none was tried
  Rounding rounding = Rounding::nearest;
};

inline constexpr double finest_sample_rate = 2.0 * highest_sample_rate;

/// Tries the grid's own rate and its multiples up to finest_sample_rate, lowest first, until the error on the rows and
/// between them is within the bound. Then leaves out the rows that the bound does not need. The clip does not move
/// after `last_key`.
SampledBake bake_sampled(const SampleSource& source, const KeyGrid& grid, Ticks last_key);

/// Makes the stream of a clip in which nothing moves: one row.
SampledBake bake_still(const SampleSource& source);

/// Samples the source at the times of the rows of `stream`, which was made of the same clip on a skeleton whose bones
/// have other places. A packet without motion keeps floats where others have int16, so lanes cannot change packets.
AlignedBytes sample_as(const SampleSource& source, const SampledStream& stream, Rounding rounding);

}  // namespace throng::anim
