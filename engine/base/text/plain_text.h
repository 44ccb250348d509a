#pragma once

#include <string>
#include <string_view>

namespace throng {

/// Returns a text from a file or a command line as one line that every terminal, window and log shows as it stands.
/// Line ends and tabs become spaces. U+FFFD replaces control characters, marks that turn the direction of writing, what
/// is invisible, and bytes that are no UTF-8.
std::string plain_text(std::string_view text);

/// Returns plain_text of a name, in quotation marks.
inline std::string in_quotes(std::string_view name) { return '"' + plain_text(name) + '"'; }

/// Says whether `text` is UTF-8.
bool is_utf8(std::string_view text);

}  // namespace throng
