#pragma once

#include <span>
#include <string>

#include "app/character/source.h"

namespace throng::app {

/// Returns the options that load these characters again with their shares, clips, placement and, where there is one
/// character, roles: "fox.glb --clips walk=Run". Words that a shell would take apart are in quotation marks. Orders of
/// bones and parts of the body have no options.
std::string cast_options(std::span<const CharacterSource> people);

}  // namespace throng::app
