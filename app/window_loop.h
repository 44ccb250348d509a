#pragma once

#include "app/settings.h"
#include "app/show.h"

namespace throng::app {

/// Runs `show` in its window until it is closed, Esc is pressed, or the frames that were asked for are over.
anim::Status run_window(Show& show, const DemoOptions& options);

}  // namespace throng::app
