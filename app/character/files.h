#pragma once

#include <string>

#include "app/character/source.h"

namespace throng::app {

/// Loads the character that comes with the program, from the folders that --data leads.
anim::Result<CharacterSource> load_built_in(const std::string& data_option, const LoadOptions& options = {});

/// Takes the roles that a person kept for the character, where there are any. The error names the file or the
/// character, and the role that cannot be.
anim::Status take_kept_roles(CharacterSource& character);

}  // namespace throng::app
