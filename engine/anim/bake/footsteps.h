#pragma once

#include <vector>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/bake/character.h"

namespace throng::anim {

/// Returns data keys "footstep_left" and "footstep_right", by time: the lowest joint of a side comes down and stands on
/// the ground. `clip` loops in place. Returns none where no foot stands, or where left and right do not take turns.
std::vector<NamedDataKey> find_footsteps(const Skeleton& skeleton, const BakedClip& clip, double height);

}  // namespace throng::anim
