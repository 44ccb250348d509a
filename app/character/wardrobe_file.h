#pragma once

#include <filesystem>
#include <string>

#include "engine/anim/asset/model.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Adds the parts of another file, whose skeleton has the same joints at rest, to those of the model of a character.
/// Errors: the file cannot be imported, it has no parts, or a joint of them is none of the character's.
anim::Status add_parts(anim::Model& model, const std::string& character, const std::filesystem::path& file);

}  // namespace throng::app
