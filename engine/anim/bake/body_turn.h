#pragma once

#include <glm/vec3.hpp>

#include "engine/anim/asset/keyframe_stream_clip.h"
#include "engine/anim/asset/root_curve.h"

namespace throng::anim {

/// Finds out whether a body as a whole turns or climbs over a clip, and not merely changes its pose. `travel` is what
/// `bone` does over the ground; `bone` is the topmost that moves. Returns the velocity of the whole root motion, by the
/// rules of find_root_motion.
RootVelocity steady_root_velocity(const Skeleton& skeleton, const StateClip& clip, int bone, const glm::dvec3& travel,
                                  double size);

}  // namespace throng::anim
