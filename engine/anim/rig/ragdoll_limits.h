#pragma once

#include <span>

#include "engine/anim/rig/ragdoll_bones.h"
#include "engine/anim/rig/ragdoll_rig.h"

namespace throng::anim {

/// How far each body may turn: a person's joints by their part, 40 degrees and 30 of twist around the bind pose for
/// what is not a person. Bodies have their axes and centres; one a chosen bone.
void set_ragdoll_limits(std::span<const RagdollBone> chosen, std::span<RagdollBody> bodies);

}  // namespace throng::anim
