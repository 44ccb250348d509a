#pragma once

#include <span>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/retarget/body_pose.h"
#include "engine/anim/retarget/retarget_plan.h"

namespace throng::anim {

/// Poses a skeleton as `source`, a pose of the other skeleton of the plan, is posed. `locals` has one a bone: on entry
/// the rest transforms, on return the pose. A bone that follows no bone keeps its rest transform.
void retarget_pose(const RetargetPlan& plan, const Skeleton& skeleton, const BodyPose& source,
                   std::span<StateTransform> locals);

}  // namespace throng::anim
