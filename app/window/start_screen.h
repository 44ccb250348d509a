#pragma once

#include "app/character/load_options.h"
#include "app/settings/settings.h"

namespace throng::app {

class Painter;

/// Does the work of a start on a thread, while the painter's window shows how far it is. Returns whether the work was
/// done: a person who closes the window, or a signal, gives it up. Errors: it failed, or the window cannot be drawn.
Result<bool> show_start(Painter& painter, const DemoOptions& options, const LongWork& work);

}  // namespace throng::app
