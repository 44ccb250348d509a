#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/character/source.h"

namespace throng::app {

/// Loads a character from each of `files`, "FILE" or "FILE#SKIN", in this order, and each that a file has where its
/// skin is "all" (skin_choice.h). One that nobody could see is refused: a skeleton without a mesh, a mesh without an
/// extent. The error names the file and what is wrong with it.
anim::Result<std::vector<CharacterSource>> load_characters(std::span<const std::string> files,
                                                           const LoadOptions& options = {});

/// Does the same with files that came together: those that hold clips alone give them to the others.
anim::Result<std::vector<CharacterSource>> load_dropped(std::span<const std::string> files,
                                                        const LoadOptions& options = {});

/// Loads the character that comes with the program, from the folders that --data leads.
anim::Result<CharacterSource> load_built_in(const std::string& data_option, const LoadOptions& options = {});

/// Takes the roles that were kept for the character the last time, where there are any. The error names the file or the
/// character, and the role that cannot be.
anim::Status take_kept_roles(CharacterSource& character);

}  // namespace throng::app
