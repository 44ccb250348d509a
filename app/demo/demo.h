#pragma once

#include "app/settings/settings.h"

namespace throng::app {

/// The interactive crowd, or the same without a display. Returns the program's exit status.
int run_demo(const DemoOptions& options);

}  // namespace throng::app
