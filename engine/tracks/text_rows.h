#pragma once

#include <cstddef>
#include <string>

#include "engine/tracks/raw_rows.h"
#include "engine/tracks/reading.h"
#include "engine/tracks/text_format.h"

namespace throng {

/// The format of a text is found by this many bytes.
inline constexpr std::size_t head_bytes = std::size_t{64} << 10U;

/// Returns the beginning of a file, up to a newline: enough to tell its format.
Result<std::string> read_head(const std::string& file);

/// Reads all rows of a text into `tracks`: its blocks, on as many threads as help.
/// Errors begin with the file's name.
Status read_rows(const std::string& file, const TextFormat& format, const TrackReading& options,
                 const ReadProgress& progress, RawTracks& tracks);

/// Returns the error of a row: "FILE: line 7: ... , or skip such rows with --lenient".
Error row_error(const std::string& file, const std::string& fault);

Error too_many_people(const std::string& file);

}  // namespace throng
