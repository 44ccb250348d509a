#pragma once

#include <vector>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// Returns data keys "footstep_left" and "footstep_right", by time: the lowest joint of a side comes down and stands on
/// the ground. `stream` loops in place. Returns none where no foot stands, or where left and right do not take turns.
std::vector<NamedDataKey> find_footsteps(const Skeleton& skeleton, const KeyframeStream& stream, double height);

}  // namespace throng::anim
