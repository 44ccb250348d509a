#pragma once

#include <cstddef>

#include "app/report/messages.h"
#include "app/report/wardrobe_report.h"
#include "app/show/show.h"

namespace throng::app {

/// Does what a person asks of the rules of a character, and says what came of it. Returns whether the rules come from
/// another file now, or from the same one as it was edited.
bool obey_wardrobe(Show& show, std::size_t character, const WardrobeCommands& commands, Messages& messages);

/// Reports the rules of a character. `standard` stays as it is.
void report_wardrobe(const Stage& stage, std::size_t character, WardrobeReport& report);
/// Reads what the file of the rules says, for the defaults to go back to; what is in force where it says nothing.
void read_standard_rules(const Stage& stage, std::size_t character, WardrobeReport& report);

}  // namespace throng::app
