#pragma once

#include "app/settings/settings.h"
#include "app/show/replay.h"
#include "app/show/show.h"

namespace throng::app {

/// Runs `show` in its window until it is closed, Esc is pressed, or the frames that were asked for are over.
/// With a `replay`, which may be null, what happens is what was recorded, to its end.
anim::Status run_window(Show& show, const DemoOptions& options, Replay* replay);

}  // namespace throng::app
