#pragma once

#include <cstddef>

#include "app/report/wardrobe_report.h"
#include "app/stage/stage.h"

namespace throng::app {

/// Reports the rules of a character. `standard` stays as it is.
void report_wardrobe(const Stage& stage, std::size_t character, WardrobeReport& report);
/// Reads what the file of the rules says, for the defaults to go back to; what is in force where it says nothing.
void read_standard_rules(const Stage& stage, std::size_t character, WardrobeReport& report);

}  // namespace throng::app
