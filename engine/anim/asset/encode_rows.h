#pragma once

#include "engine/anim/asset/sampled_rows.h"
#include "engine/anim/base/aligned_bytes.h"

namespace throng::anim {

/// Makes a SampledStream of rows. `duration` is the clip's.
AlignedBytes encode_rows(const SampledRows& rows, Ticks duration);

}  // namespace throng::anim
