#pragma once

#include "app/commands/inspect/options.h"

namespace throng::app {

/// Runs `throng inspect`. Returns the exit status; a file that is refused gives one line on stderr.
int run_inspect(const InspectOptions& options);

}  // namespace throng::app
