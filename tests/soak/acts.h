#pragma once

#include <map>
#include <string>

#include "app/show/show.h"
#include "tests/soak/command_lines.h"

namespace throng::soak {

/// Does one thing that a person can do at the window, and counts it by name. What is refused in words changes nothing.
void act_at_random(app::Show& show, const Models& models, Random& random, std::map<std::string, int>& counts);

}  // namespace throng::soak
