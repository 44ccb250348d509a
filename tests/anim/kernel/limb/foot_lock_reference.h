#pragma once

#include "engine/anim/kernel/limb/foot_lock.h"

namespace throng::anim {

/// Makes one step of the lock of one foot, without vectors. The kernels are held to it. `posed` is the footing where
/// the pose has the foot. `planted` is 0 to 1; the foot locks from a half on. `reached` is the share of the way from
/// there to its footing that its leg reached in the last step. Returns the footing to use. All is in world space. The
/// footing never jumps: a foot locks where it is, and its distance from the pose fades out when it is let go.
Footing step_foot_lock(FootLock& lock, const Footing& posed, float planted, const FootLockOptions& options,
                       float seconds, float reached = 1.0F);

/// Returns how high a planted foot steps on its way back from a lock that it was released from, metres.
float rise_of_step(const FootLock& lock, float planted, const FootLockOptions& options, float least = 0.0F);

/// Adds to `slid` how far the ball of the foot got since the last frame, in world space, if it was planted all the
/// while.
void measure_slide(FootLock& lock, const glm::vec3& ball, float planted, float seconds);

}  // namespace throng::anim
