#pragma once

#include <string>

#include "app/character/load_options.h"
#include "app/character/source.h"
#include "engine/base/result.h"

namespace throng::app {

/// Loads a character anew with another size and place. Roles, share, order of bones and parts of the body stay. `data`
/// is what --data says, for the built-in character. Errors: its file cannot be used any more, or holds another
/// character now; or the character would have no height, or one beyond all measure.
anim::Result<CharacterSource> placed_anew(const CharacterSource& character, const anim::PlacementChoice& choice,
                                          const LoadOptions& options, const std::string& data);

}  // namespace throng::app
