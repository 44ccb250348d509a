#pragma once

#include "engine/anim/asset/model.h"
#include "engine/base/result.h"

namespace throng::anim {

/// Checks that a model keeps the promises of its types: every index names something, lists that belong together are of
/// one length, every number is finite, keys ascend. Imported models always do; a model that a host makes or changes may
/// not be. Errors: the first fault, by the name of the bone, clip or mesh.
Status check_model(const Model& model);

}  // namespace throng::anim
