#pragma once

#include <optional>

#include "app/report/selection_report.h"
#include "app/stage/stage.h"

namespace throng::app {

/// What there is to say of the selected agent; nothing if nobody is. Allocates.
std::optional<SelectionReport> report_selection(const Stage& stage);

}  // namespace throng::app
