#pragma once

#include <span>
#include <string>

#include "app/character/cast_files.h"
#include "app/show/request/chosen_character.h"

namespace throng::app {

/// Loads the characters of a crowd file and gives them all that the person chose. `data` is the folder that --data
/// names, where the built-in character is. Errors: a file cannot be shown, or lacks a thing that the person chose.
Result<LoadedCast> load_crowd(std::span<const ChosenCharacter> characters, const std::string& data,
                              const LoadOptions& options = {});

}  // namespace throng::app
