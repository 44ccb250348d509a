#pragma once

#include <string>
#include <vector>

namespace throng::app {

/// Returns the last line of a text that is not blank; empty if there is none.
std::string last_line(const std::string& text);

/// Returns the words as a person would give them to a shell.
std::string as_typed(const std::vector<std::string>& words);

}  // namespace throng::app
