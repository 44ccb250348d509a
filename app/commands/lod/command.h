#pragma once

#include "app/commands/lod/options.h"

namespace throng::app {

/// Runs `throng lod`: measures the cost of each bone level of a character in time and in pixels. Returns the exit
/// status.
int run_lod(const LodOptions& options);

}  // namespace throng::app
