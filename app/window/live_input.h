#pragma once

#include <memory>

#include "app/settings/settings.h"
#include "engine/base/result.h"
#include "engine/tracks/live/live_tracks.h"

namespace throng::app {

/// Begins to read the rows of a live crowd from standard input, and waits for the first, or until a signal asks the run
/// to end. Returns null where the options name no standard input. Errors: it ends without a row, or is wrong.
anim::Result<std::unique_ptr<LiveTracks>> open_live_input(const DemoOptions& options);

}  // namespace throng::app
