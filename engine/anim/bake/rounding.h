#pragma once

#include "engine/anim/asset/sampled_rows.h"
#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// Says how the rotations of a sampled stream are rounded to 16 bits.
enum class Rounding : unsigned char {
  nearest,  ///< each by itself, so that errors add up along a chain of bones
  carried,  ///< each makes up for its parents' rounding, so that a bone errs by its own rounding alone
};

/// Rounds the rotations of a stream anew, as Rounding::carried says. `rows` are the poses that it was made of. Packets
/// whose rotations stand still keep them.
void carry_rounding(const Skeleton& skeleton, const SampledRows& rows, SampledStream& stream);

}  // namespace throng::anim
