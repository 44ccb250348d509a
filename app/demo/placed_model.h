#pragma once

#include <string>

#include "app/report/placement_report.h"
#include "app/show/show.h"

namespace throng::app {

/// Gives a character the size and place that a person asks for. Returns a sentence for people: what came of it and how
/// long it took, or why it cannot be.
std::string place_model(Show& show, const NewPlacement& asked);

}  // namespace throng::app
