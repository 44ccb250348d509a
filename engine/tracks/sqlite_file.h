#pragma once

#include <string>
#include <string_view>

#include "engine/tracks/raw_rows.h"
#include "engine/tracks/reading.h"

namespace throng {

/// Returns whether a file with this beginning is a database.
bool is_sqlite(std::string_view head);

/// Reads the rows and the place of a database of JuPedSim. Opens it read-only, takes no part in other programs'
/// transactions (a journal with rows beside it is refused), and runs nothing that the file brings along.
/// Errors begin with the file's name.
Status read_sqlite(const std::string& file, const TrackReading& options, const ReadProgress& progress,
                   RawTracks& tracks);

/// Reads the place alone.
Result<FilePlan> read_sqlite_plan(const std::string& file);

}  // namespace throng
