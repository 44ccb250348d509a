#pragma once

#include <string>

#include "app/trajectory/raw_rows.h"
#include "app/trajectory/reading.h"
#include "app/trajectory/trajectories.h"

namespace throng::app {

/// Makes people of rows: tells apart what the file does not say, moves them about an origin in their middle, and sorts.
/// Empties `tracks` as it goes. Errors begin with the file's name.
Result<Trajectories> tracks_of_rows(RawTracks& tracks, const std::string& file, const TrackReading& options);

/// Returns radians from +Z towards +X of an angle of a file.
float heading_of_angle(float angle, AngleMeaning meaning);

}  // namespace throng::app
