#pragma once

#include <string>

namespace throng::app {

/// Asks the window of a display to close, as its close button does. Returns false if there is no window that listens.
bool press_close_button(const std::string& display);

}  // namespace throng::app
