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

/// Loads a character anew with another size and place. Roles, share, order of bones and parts of the body stay. `data`
/// is what --data says, for the built-in character. Errors: its file cannot be used any more, or holds another
/// character now; or the character would have no height, or one beyond all measure.
Result<CharacterSource> placed_anew(const CharacterSource& character, const anim::PlacementChoice& choice,
                                    const LoadOptions& options, const std::string& data);

}  // namespace throng::app
