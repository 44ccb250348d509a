#pragma once

#include "app/commands/lod/options.h"

namespace throng::app {

/// Runs `throng lod`: what each bone level of a character costs in time and in pixels, measured. Exit status.
int run_lod(const LodOptions& options);

}  // namespace throng::app
