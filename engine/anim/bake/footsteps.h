#pragma once

#include <vector>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// Data keys "footstep_left" and "footstep_right" at the instants at which the lowest joint of a side, on its way down,
/// comes to stand on the ground, by time. `stream` loops in place. None where that is no walk: where nobody stands, or
/// where left and right do not take turns.
std::vector<NamedDataKey> find_footsteps(const Skeleton& skeleton, const KeyframeStream& stream, double height);

}  // namespace throng::anim
