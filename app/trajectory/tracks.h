#pragma once

#include <string>

#include "app/trajectory/raw_rows.h"
#include "app/trajectory/reading.h"
#include "app/trajectory/told_apart.h"
#include "app/trajectory/trajectories.h"

namespace throng::app {

/// Makes people of rows: finds what the file does not say, moves them about an origin in their middle, and sorts.
/// Empties `tracks` as it goes. Errors begin with the file's name.
Result<Trajectories> tracks_of_rows(RawTracks& tracks, const std::string& file, const TrackReading& options);

/// Returns a row about an origin. Its height and its angle stay as they are, but for the unit.
TrackRow track_row(const RawRow& raw, const RowScale& scale, const glm::dvec2& origin);

/// Turns a row whose y points up into a row whose z points up.
void swap_up(RawRow& row);

/// Returns an angle of a file in radians from +Z towards +X.
float heading_of_angle(float angle, AngleMeaning meaning);

}  // namespace throng::app
