#pragma once

#include "app/commands/compare/options.h"

namespace throng::app {

/// Runs `throng compare`: measures how far two pictures are apart. Returns the exit status.
int run_compare(const CompareOptions& options);

}  // namespace throng::app
