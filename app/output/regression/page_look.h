#pragma once

#include <string_view>

namespace throng::app {

/// The styles and the program of the page, which stand inside it.
extern const std::string_view page_styles;
extern const std::string_view page_script;

}  // namespace throng::app
