#pragma once

#include <string>

namespace throng::app {

/// Shows a line on standard error in place of the line before, if that is a terminal; an empty text clears the line.
void show_progress(const std::string& text);
/// Returns whether standard error is a terminal.
bool shows_progress();

}  // namespace throng::app
