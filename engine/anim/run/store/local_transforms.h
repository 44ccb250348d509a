#pragma once

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/run/store/strip_joints.h"

namespace throng::anim {

/// Writes local transforms of the bones of one packet of a character, as Bone::rest has them: prefix * T * R * S is the
/// bone in the space of its parent. `state` is [components][16]; `locals` has room for every bone.
void write_locals(const Skeleton& skeleton, int packet, QuadMask displaced, const float* state, Transform* locals);

}  // namespace throng::anim
