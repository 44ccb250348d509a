#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "throng/render/scenery_data.h"

#include "engine/base/result.h"

namespace throng::app {

/// Reads the props of assets/places.glb, which `data_option` (--data) helps to find, with all their levels of detail.
/// Errors: the file is missing or damaged; the sentence names it.
Result<std::vector<render::SceneryMeshData>> load_props(const std::string& data_option);

/// Reads the props of a file.
Result<std::vector<render::SceneryMeshData>> read_props(const std::filesystem::path& file);

}  // namespace throng::app
