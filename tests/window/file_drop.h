#pragma once

#include <string>

#include "tests/window/child_process.h"

namespace throng::app {

/// Drops a file on the window of the display that takes drops, as a file manager does (XDND, version 5). Returns false
/// if there is no such window, or if it did not take the file before the deadline.
bool drop_file(const std::string& display, const std::string& file, Deadline deadline);

}  // namespace throng::app
