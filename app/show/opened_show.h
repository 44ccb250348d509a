#pragma once

#include <memory>

#include "app/show/show.h"
#include "app/show/starting_characters.h"
#include "engine/tracks/live/live_tracks.h"

namespace throng::app {

/// Opens the show that the command line asks for, and says on a terminal how far it is. `live` has a head, and is there
/// where the options name standard input. Returns null and sets the error where the show cannot begin.
std::unique_ptr<Show> open_show(const DemoOptions& options, StartError& error, std::unique_ptr<LiveTracks> live = {});

}  // namespace throng::app
