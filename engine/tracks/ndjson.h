#pragma once

#include <string_view>

#include "engine/tracks/text_format.h"

namespace throng {

/// Reads JSON objects, one a line: {"track": {"f": 10, "p": 7, "x": 1.5, "y": 2}} as trajnet writes them, with its
/// scenes, or {"id": 7, "time": 0.4, "x": 1.5, "y": 2} with the names that columns of tables may have.
/// `first` is the first line. The error is the end of a sentence.
Result<TextFormat> ndjson_format(std::string_view first);

}  // namespace throng
