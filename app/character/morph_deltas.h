#pragma once

#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/render/crowd_mesh_data.h"

namespace throng::app {

/// Returns what the model's morphs do to its surface, as drawing takes it.
std::vector<render::MorphDeltaData> morph_deltas(const anim::Model& model);

}  // namespace throng::app
