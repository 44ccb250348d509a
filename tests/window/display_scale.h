#pragma once

#include <memory>
#include <string>

namespace throng::app {

/// Tells programs that start on a display from now on how many dots it has in an inch, as a desktop does; 96 is a plain
/// screen. It holds as long as the returned connection; null: there is no such display.
std::shared_ptr<void> with_dots_per_inch(const std::string& display, int dots);

}  // namespace throng::app
