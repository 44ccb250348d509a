#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/tracks/trajectories.h"

namespace throng::app {

struct InspectOptions;
struct LineCounts;

/// Says for a person what a file of trajectories holds: people, rows, time and place, findings and oddities; and how
/// many people `passed` a line, where they are counted.
std::string tracks_text(const Trajectories& tracks, const LineCounts* passed = nullptr);

/// Returns the same facts as one JSON object; README.md beside this file lists the keys.
std::string tracks_json(const Trajectories& tracks, const LineCounts* passed = nullptr);

/// Prints the answer about a file of trajectories, and writes the table of its people if that is asked for. Errors: the
/// file is refused, has no row in the part that is asked for, or the table cannot be written.
Status inspect_tracks(const InspectOptions& options);

}  // namespace throng::app
