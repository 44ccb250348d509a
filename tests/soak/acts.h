#pragma once

#include "app/show/show.h"
#include "tests/soak/command_lines.h"
#include "tests/soak/round.h"

namespace throng::soak {

/// Does one thing that a person can do at the window, and counts it by name. What is refused in words changes nothing.
void act_at_random(app::Show& show, const Models& models, Random& random, Counts& counts);

}  // namespace throng::soak
