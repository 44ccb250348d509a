#pragma once

#include <cstddef>

#include "app/show/report/frame_report.h"

namespace throng::app {

class Show;
class Stage;

/// Reports the meshes with which a character is drawn in the last drawn frame.
MeshReport report_meshes(const Show& show, std::size_t character);

/// Reports the rules of a character. `standard` stays as it is.
void report_wardrobe(const Stage& stage, std::size_t character, WardrobeReport& report);
/// Reads the file of the rules, for the defaults to go back to; without a readable file, takes the rules in force.
void read_standard_rules(const Stage& stage, std::size_t character, WardrobeReport& report);

}  // namespace throng::app
