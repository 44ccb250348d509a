#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/window/window_session.h"

namespace throng::app {

/// A recorded crowd that is to be read.
struct TracksToRead {
  std::string file, walls;  ///< `walls` may be empty
};

/// Returns the files to read of files that were dropped together: trajectories, walls, or both. `shown` is the
/// file of the crowd in the window, to which walls alone belong; empty: it is no recorded crowd. Returns nothing if no
/// file has trajectories or walls. Errors: they do not go together.
Result<std::optional<TracksToRead>> tracks_to_read(std::span<const std::string> files, const std::string& shown);

/// Opens the recorded crowd of files that were dropped together, if tracks_to_read() finds one, or says why it cannot
/// be. Returns whether there is one.
bool open_tracks(const std::vector<std::string>& files, WindowSession& session);

}  // namespace throng::app
