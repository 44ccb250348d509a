#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace throng::import {

bool is_data_uri(std::string_view uri);

/// Returns the bytes of a data URI (RFC 2397), in base64 or with percent signs. Schemes and "base64" may have letters
/// of either case. It holds no more than twice the length of the URI. Throws Refusal.
std::vector<std::byte> decode_data_uri(std::string_view uri);

/// Replaces "%41" by "A". A percent sign without two hexadecimal digits stays.
std::string decode_percent(std::string_view text);

/// Says whether two texts are equal but for the case of the letters a to z.
bool equal_without_case(std::string_view a, std::string_view b);

}  // namespace throng::import
