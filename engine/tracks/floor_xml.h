#pragma once

#include <string_view>

#include "engine/tracks/file_plan.h"

namespace throng {

/// Reads a .floor of crowd:it: walls that are closed become obstacles, and the others walls. A file with one closed
/// wall alone means the floor within it. The error is the end of a sentence, "line 3: ...; ...".
Result<FilePlan> parse_floor(std::string_view text);

}  // namespace throng
