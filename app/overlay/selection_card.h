#pragma once

#include "app/overlay/widgets.h"
#include "app/report/frame_report.h"

namespace throng::app {

/// Who was clicked at, in the upper left of `place`, where there is mostly sky: what they do, and the graph of entities
/// that makes their pose.
void show_selection_card(Widgets& widgets, const Area& place, const SelectionReport& selected,
                         OverlayCommands& commands);

}  // namespace throng::app
