#pragma once

#include <span>
#include <string>
#include <string_view>

namespace throng::app {

/// Returns a text as it stands in XML and HTML, also inside quotation marks. Characters unknown to XML become U+FFFD.
std::string escaped(std::string_view text);

/// Returns bytes in base64, as a data URI has them.
std::string in_base64(std::span<const std::byte> bytes);

}  // namespace throng::app
