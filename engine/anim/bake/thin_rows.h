#pragma once

#include <cstdint>
#include <vector>

#include "engine/anim/asset/sampled_rows.h"
#include "engine/anim/bake/sample_source.h"

namespace throng::anim {

/// Finds out which rows of a clip a stream needs, so that no point of the proxy is farther off than `allowed`. From
/// each row it looks for the farthest next one. `stream` has all `rows`, one step apart. Returns the gaps of the rows
/// that stay (SampledRows::gaps). It looks at each step and midway between two, and no closer: the caller measures
/// the thinned stream.
std::vector<std::uint8_t> thin_rows(const SampleSource& source, const SampledRows& rows, const SampledStream& stream,
                                    double allowed);

}  // namespace throng::anim
