#pragma once

#include <string>

#include "engine/tracks/database.h"
#include "engine/tracks/raw_rows.h"
#include "engine/tracks/reading.h"

namespace throng {

/// Reads the rows of trajectory_data from the pages of the file, on as many threads as help. Returns false, and leaves
/// `tracks` as they are, where a row is wrong or the table is unusual: then SQLite reads it, and says what is wrong.
bool read_page_rows(const std::string& file, const Database::Table& table, const TrackReading& options,
                    const ReadProgress& progress, RawTracks& tracks);

}  // namespace throng
