#pragma once

#include <span>

#include "engine/anim/rig/ragdoll_bones.h"
#include "engine/anim/rig/ragdoll_rig.h"

namespace throng::anim {

/// Sets how far each body may turn. A person's joints turn by their part, all others by 40 degrees and 30 of twist
/// around the bind pose. `bodies` has one a chosen bone, with axes and centres.
void set_ragdoll_limits(std::span<const RagdollBone> chosen, std::span<RagdollBody> bodies);

}  // namespace throng::anim
