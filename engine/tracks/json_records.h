#pragma once

#include <string>
#include <string_view>

#include "engine/tracks/raw_rows.h"
#include "engine/tracks/reading.h"

namespace throng {

/// Returns whether a file with this beginning is one JSON document: a list, or an object that is no row.
bool is_json_document(std::string_view head);

/// Reads the objects of a document that have x and y, at any depth, by the names that columns of tables may have. An
/// object has the fields of the objects around it besides: {"time": 0.4, "people": [{"id": 7, "x": 1.5, "y": 2}]} is a
/// row, as is {"id": 7, "way": [{"time": 0.4, "x": 1.5, "y": 2}]}. The document is of at most 16 MiB.
/// Errors begin with the file's name.
Status read_json_records(const std::string& file, const TrackReading& options, RawTracks& tracks);

}  // namespace throng
