#pragma once

#include "app/settings/settings.h"

namespace throng::app {

class Replay;
class Show;

/// Runs `show` in its window until a person closes it or presses Esc, or the frames that were asked for are over.
/// A `replay` that is not null repeats its recording, to its end.
Status run_window(Show& show, const DemoOptions& options, Replay* replay);

}  // namespace throng::app
