#pragma once

#include <vector>

#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// The state in which every bone stands to its parent as in the bind pose, so that what is skinned to it follows the
/// parent: what a level of detail without the bone shows. float [packet][components][16]. The identity on rigid
/// skeletons; on others from the inverse bind matrices (without shear), and the rest transform where there is none.
std::vector<float> still_pose(const Skeleton& skeleton);

}  // namespace throng::anim
