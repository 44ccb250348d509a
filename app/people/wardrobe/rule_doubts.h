#pragma once

#include <string>
#include <vector>

#include "app/people/wardrobe/cast_rules.h"
#include "app/people/wardrobe/wardrobe.h"

namespace throng::app {

/// Says what rules hold that cannot be meant: a scene of no such name, weights that are all 0, people without legs.
/// Each doubt is the end of a sentence that begins with the name of the rules' file, and says what to do. An empty
/// wardrobe, where nothing is drawn, raises no doubts about its parts.
std::vector<std::string> doubts_of(const CastRules& rules, const Wardrobe& wardrobe);

}  // namespace throng::app
