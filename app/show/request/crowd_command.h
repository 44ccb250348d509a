#pragma once

#include <span>
#include <string>

#include "app/character/source.h"
#include "app/show/request/crowd_file.h"

namespace throng::app {

/// Returns the command line that opens a setup again: "throng fox.glb --clips walk=Run --agents 300". Words that a
/// shell would take apart are in quotation marks. `people` are the characters of the setup as they are now. What no
/// option says is in the JSON of `--crowd`, whatever it is.
std::string crowd_command(const CrowdSetup& setup, std::span<const CharacterSource> people);

}  // namespace throng::app
