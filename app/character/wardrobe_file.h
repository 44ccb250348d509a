#pragma once

#include <filesystem>

#include "app/character/source.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Adds the parts of another file, whose skeleton has the same joints at rest, to those of a character. Errors: the
/// file cannot be imported, it has no parts, or a joint of them is none of the character's.
anim::Status add_parts(CharacterSource& source, const std::filesystem::path& file);

}  // namespace throng::app
