#pragma once

#include <string>

#include "engine/anim/import/import.h"

namespace throng::app {

/// Imports as import::import_file() does, with the channels of vertices that drawing takes.
Result<anim::ImportedFile> import_to_draw(const std::string& path, import::ImportOptions options = {});

}  // namespace throng::app
