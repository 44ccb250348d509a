#pragma once

#include "app/report/messages.h"
#include "app/report/placement_report.h"
#include "app/show/show.h"

namespace throng::app {

/// Gives a character the size and place that a person asks for, and says what came of it and how long it took, or why
/// it cannot be.
void place_model(Show& show, const NewPlacement& asked, Messages& messages);

}  // namespace throng::app
