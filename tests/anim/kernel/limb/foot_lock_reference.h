#pragma once

#include "engine/anim/kernel/limb/foot_lock.h"

namespace throng::anim {

/// One step of the lock of one foot, without vectors: what the kernels are held to. `posed` is the footing where the
/// pose has the foot, `planted` 0 to 1: from a half on it locks. Returns the footing to use, all in world space. Never
/// jumps: a foot locks where it is, and what it is away from the pose when it is let go fades out.
Footing step_foot_lock(FootLock& lock, const Footing& posed, float planted, const FootLockOptions& options,
                       float seconds);

/// Adds to `slid` how far the ball of the foot got since the last frame, if it was planted all the while. World space.
void measure_slide(FootLock& lock, const glm::vec3& ball, float planted, float seconds);

}  // namespace throng::anim
