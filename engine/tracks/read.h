#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/tracks/reading.h"
#include "engine/tracks/trajectories.h"

namespace throng {

/// Reads a recorded or simulated crowd. README.md beside this file lists the formats, which are told apart by the
/// contents of the file. It takes at most 100 bytes of memory a row, and calls `progress` from this thread. Errors: one
/// sentence that begins with the file's name, names the line, and says what to do.
Result<Trajectories> read_trajectories(const std::string& file, const TrackReading& options,
                                       const ReadProgress& progress = {});

/// Returns whether `file` begins as files of trajectories do, so that it is no model.
bool looks_like_trajectories(const std::string& file);

}  // namespace throng
