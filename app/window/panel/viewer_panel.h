#pragma once

#include <string>

#include "app/show/report/viewer_report.h"
#include "app/show/request/requests.h"
#include "app/window/panel/controls/widgets.h"

namespace throng::app {

/// All that the viewer's panel remembers from frame to frame.
struct ViewerPanelMemory {
  std::string search;  ///< the panel shows the clips whose names have it
};

/// Shows the viewer of one character in the place of the tabs: its clips, their time, and its drawn parts.
void show_viewer_panel(Widgets& widgets, const std::string& name, const ViewerReport& report, ViewerPanelMemory& memory,
                       Requests& requests);

/// Writes the name of the bone whose joint is under the pointer there, while bones are drawn.
void show_bone_name(const Theme& theme, const Area& picture, const ViewerReport& report);

}  // namespace throng::app
