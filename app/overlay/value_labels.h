#pragma once

#include <string>
#include <string_view>

namespace throng::app {

/// Returns the name that the panel gives the tuning's value with that key; the key in words where no row shows it.
std::string label_of(std::string_view key);

}  // namespace throng::app
