#pragma once

#include "engine/anim/asset/sampled_stream.h"
#include "engine/anim/bake/sample_source.h"

namespace throng::anim {

/// Times the bound: rounding alone errs less, so other rounding cannot mend more.
inline constexpr double hopeless_error = 4.0;

/// Returns the largest distance on the proxy between the two streams: on every step, at several times between steps,
/// many around the worst, and on both sides of every jump. It counts the error that the rounding of times between rows
/// may add. Stops early, with the error so far, where this is many times the bound.
double measure_error(const SampleSource& source, const SampledStream& stream);

}  // namespace throng::anim
