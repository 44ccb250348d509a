#pragma once

#include <filesystem>
#include <string>

#include "engine/anim/asset/model.h"
#include "engine/base/result.h"

namespace throng::app {

/// Adds the parts of another file, whose skeleton has the same joints at rest, to the parts of a character's model.
/// Errors: the file cannot be imported, it has no parts, or the character lacks one of their joints.
anim::Status add_parts(anim::Model& model, const std::string& character, const std::filesystem::path& file);

}  // namespace throng::app
