#pragma once

#include "app/overlay/widgets.h"
#include "app/report/selection_report.h"

namespace throng::app {

/// The channels of the selected agent, what each is made of, and what changes their pose; how much of each there is.
void show_layers(Widgets& widgets, const SelectionReport& selected);

}  // namespace throng::app
