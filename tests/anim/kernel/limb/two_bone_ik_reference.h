#pragma once

#include <span>

#include "engine/anim/kernel/limb/two_bone_ik.h"

namespace throng::anim {

/// Does what two_bone_ik.h says for one limb, without vectors. The kernels are held to it. Returns how far the end is
/// from the target.
float two_bone_ik_by_definition(const TwoBoneIkJob& job);

/// Does the same where the limb's chain is posed already: `motions` [chain.count] are the pose's, and follow it.
float two_bone_ik_by_definition(const TwoBoneIkJob& job, std::span<JointMotion> motions);

/// The largest distance of rotations from the definition's. The lengths of a limb that is all but straight say its
/// angle only to the root of what a float tells apart, however it is computed. The place of its end hardly depends on
/// it.
inline constexpr float limb_rotation_tolerance = 1e-3F;

/// Returns the posed length of the limb when straight, in metres.
float limb_length(const TwoBoneLimb& limb, std::span<const JointMotion> motions);

}  // namespace throng::anim
