#pragma once

#include <optional>
#include <span>
#include <string>

#include "app/character/source.h"
#include "app/show/request/request.h"
#include "engine/base/result.h"

namespace throng::app {

/// A request for the characters that are shown, who also play the clips of other files, and a sentence that says it.
struct LentClips {
  SetCast request;
  std::string words;
};

/// Lends files of clips alone to all characters whose bones they fit. Roles that had no clip are guessed anew. Returns
/// nothing where a file holds more than clips. Errors: a file fits no character, or each one plays it already.
Result<std::optional<LentClips>> lent_clips(std::span<const std::string> files,
                                            std::span<const CharacterSource> people);

}  // namespace throng::app
