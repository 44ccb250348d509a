#pragma once

#include <vector>

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// For each bone how far the surface at and below it is off when the bone and all below it follow its parent as in the
/// bind pose: metres, what a level of detail without that limb costs. The farthest point of each pose counts, and of
/// poses spread over all clips the 99th percentile.
std::vector<double> bone_errors(const Model& model);

/// The same for ordering bones: a model without clips, which shows no errors, counts the farthest distance of a point
/// from the bone.
std::vector<double> bone_importance(const Model& model);

}  // namespace throng::anim
