#pragma once

#include <string>

#include "engine/tracks/raw_rows.h"
#include "engine/tracks/reading.h"
#include "engine/tracks/row_meaning.h"
#include "engine/tracks/trajectories.h"

namespace throng {

/// Makes people of rows: finds what the file does not say, moves them about an origin in their middle, and sorts.
/// Empties `tracks` as it goes. Errors begin with the file's name.
Result<Trajectories> tracks_of_rows(RawTracks& tracks, const std::string& file, const TrackReading& options);

/// Returns a row about an origin. Its height and its angle stay as they are, but for the unit.
TrackRow track_row(const RawRow& raw, const RowScale& scale, const glm::dvec2& origin);

/// Turns a row whose y points up into a row whose z points up.
void swap_up(RawRow& row);

/// Returns an angle of a file in radians from +Z towards +X.
float heading_of_angle(float angle, AngleMeaning meaning);

}  // namespace throng
