#pragma once

#include <string>

#include "app/show/report/frame_report.h"
#include "app/show/request/requests.h"
#include "app/window/panel/controls/widgets.h"

namespace throng::app {

/// The height that show_tracked_person() has use for, and the least, in pixels of a plain screen.
inline constexpr float tracked_person_height = 160, least_tracked_person_height = 120;

/// Returns "walk", or that the person is not there at that time.
std::string state_of_tracked(const SelectionReport& selected, double seconds);

/// Shows the selected person of a recorded crowd: where they are, and their speed and steps over the time in which they
/// are there. A press in the graph goes to the time there.
void show_tracked_person(Widgets& widgets, const Area& place, const FrameReport& report, Requests& requests);

}  // namespace throng::app
