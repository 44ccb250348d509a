#pragma once

#include "app/settings/settings.h"

namespace throng::app {

/// Runs the crowd, in a window or without a display. Returns the program's exit status.
int run_demo(const DemoOptions& options);

}  // namespace throng::app
