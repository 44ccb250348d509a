#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace throng::import {

/// Returns the bytes of a data URI (RFC 2397), in base64 or with percent signs, or nothing for any other URI. Schemes
/// and "base64" may have letters of either case. Throws Refusal.
std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri);

/// Replaces "%41" by "A". A percent sign without two hexadecimal digits stays.
std::string decode_percent(std::string_view text);

/// Says whether two texts are equal but for the case of the letters a to z.
bool equal_without_case(std::string_view a, std::string_view b);

}  // namespace throng::import
