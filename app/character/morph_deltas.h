#pragma once

#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/render/crowd_mesh_data.h"

namespace throng::app {

/// Returns the changes that the model's morphs make to its surface, as drawing takes them.
std::vector<render::MorphDeltaData> morph_deltas(const anim::Model& model);

}  // namespace throng::app
