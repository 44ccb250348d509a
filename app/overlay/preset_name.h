#pragma once

#include <string>

namespace throng::app {

/// A name that a preset can be kept under: letters, digits, blanks inside, - and _.
bool can_name_a_preset(const std::string& name);

}  // namespace throng::app
