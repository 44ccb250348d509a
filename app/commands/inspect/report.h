#pragma once

#include <string>

#include "engine/anim/asset/model.h"

namespace throng::app {

/// Says for a person, in tables, what a file holds: each character with its size, clips, meshes and materials, and what
/// import repaired, left out and guessed.
std::string inspection_text(const anim::ImportedFile& file);

}  // namespace throng::app
