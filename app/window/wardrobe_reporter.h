#pragma once

#include <cstddef>

namespace throng::app {

class Stage;
struct WardrobeReport;

/// Reports the rules of a character. `standard` stays as it is.
void report_wardrobe(const Stage& stage, std::size_t character, WardrobeReport& report);
/// Reads the file of the rules, for the defaults to go back to; without a readable file, takes the rules in force.
void read_standard_rules(const Stage& stage, std::size_t character, WardrobeReport& report);

}  // namespace throng::app
