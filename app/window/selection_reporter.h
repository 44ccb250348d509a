#pragma once

#include <optional>

#include "app/show/report/selection_report.h"

namespace throng::app {

class Stage;

/// Returns the report of the selected agent, or nothing where no agent is selected. Allocates.
std::optional<SelectionReport> report_selection(const Stage& stage);

}  // namespace throng::app
