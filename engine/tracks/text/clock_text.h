#pragma once

#include <string_view>

namespace throng {

/// Reads a time of day, "00:01:02.5", or a moment of ISO 8601, "2026-05-01T12:00:00.100Z"; returns whether the text is
/// one. The value is seconds: since midnight, or since 1970. A time zone is left out, since a file has one.
bool is_clock_text(std::string_view text, double& value);

}  // namespace throng
