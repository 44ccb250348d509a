#pragma once

#include <functional>
#include <memory>

#include "app/show/show.h"
#include "app/show/starting_characters.h"
#include "engine/tracks/live/live_tracks.h"

namespace throng::app {

/// Does the work that a start takes, and shows how far it is. Returns whether it was done; not where a person gave it
/// up. Errors: it failed, or its progress cannot be shown.
using StartWork = std::function<Result<bool>(Painter& painter, const LongWork& work)>;
/// Does it at once and shows nothing.
Result<bool> start_at_once(Painter& painter, const LongWork& work);

/// Opens the show that the command line asks for, and says on a terminal how far it is. `live` has a head, and is there
/// where the options name standard input. Files are read by `do_work`. Returns null and sets the error where the show
/// cannot begin; the error has no words where a person gave the start up.
std::unique_ptr<Show> open_show(const DemoOptions& options, StartError& error, std::unique_ptr<LiveTracks> live = {},
                                const StartWork& do_work = start_at_once);

}  // namespace throng::app
