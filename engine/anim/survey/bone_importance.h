#pragma once

#include <vector>

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// Returns for each bone how far the surface at and below it is off, in metres, when the bone and all below it follow
/// its parent as in the bind pose. A level of detail without that limb has this error. Takes the farthest point of each
/// pose, and the 99th percentile over poses of all clips.
std::vector<double> bone_errors(const Model& model);

/// Returns these errors to order bones by. A model without clips shows no errors, so each bone gets the distance of its
/// farthest point.
std::vector<double> bone_importance(const Model& model);

}  // namespace throng::anim
