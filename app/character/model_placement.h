#pragma once

#include <span>
#include <string>

#include "app/character/load_options.h"
#include "app/character/source.h"
#include "engine/base/result.h"

namespace throng::app {

/// Returns the size and place that options give a file, "FILE" or "FILE#SKIN".
anim::PlacementChoice placement_for(const std::string& file, const LoadOptions& options);

/// Errors: a placement names a model that is not among the characters. The error names the characters.
Status check_placed_models(std::span<const ModelPlacement> placements, std::span<const CharacterSource> characters);

}  // namespace throng::app
