#pragma once

#include <vector>

#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// Returns the state in which every bone stands to its parent as in the bind pose, so that its skin follows the parent.
/// A level of detail without the bone shows this. The layout is float [packet][components][16]. On rigid skeletons it
/// is the identity; on others it comes from the inverse bind matrices (without shear), or from the rest transform where
/// a bone has none.
std::vector<float> still_pose(const Skeleton& skeleton);

}  // namespace throng::anim
