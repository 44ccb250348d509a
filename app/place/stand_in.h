#pragma once

#include <vector>

#include "engine/render/scenery_data.h"

namespace throng::app {

/// Returns a box for each prop, of about its size.
std::vector<render::SceneryMeshData> stand_in_props();

}  // namespace throng::app
