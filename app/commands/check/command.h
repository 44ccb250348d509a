#pragma once

#include "app/commands/check/options.h"

namespace throng::app {

/// Runs `throng check`: draws the cases of a file and holds them against the expected pictures. Returns the exit
/// status.
int run_check(const CheckOptions& options);

}  // namespace throng::app
