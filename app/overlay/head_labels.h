#pragma once

#include "app/overlay/widgets.h"
#include "app/report/frame_report.h"

namespace throng::app {

/// Writes what level of detail gives each agent of the report above its head: the interval in frames, and after it the
/// bone level where bones are dropped.
void show_head_labels(Widgets& widgets, const Area& crowd, const FrameReport& report);

}  // namespace throng::app
