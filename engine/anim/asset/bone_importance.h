#pragma once

#include <vector>

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// For each bone the farthest that a point of the surface at or below it is off, over poses of all clips, when the bone
/// and all below it follow its parent: metres, and what a level of detail without that limb costs. A model without
/// clips counts the farthest distance of such a point from the bone, one without a surface that of the bones below it.
std::vector<double> bone_importance(const Model& model);

}  // namespace throng::anim
