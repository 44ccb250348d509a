#pragma once

#include <optional>

#include "app/show/report/selection_report.h"
#include "app/show/stage/stage.h"

namespace throng::app {

/// Returns the report of the selected agent, or nothing where no agent is selected. Allocates.
std::optional<SelectionReport> report_selection(const Stage& stage);

}  // namespace throng::app
