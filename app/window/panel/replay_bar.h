#pragma once

#include "app/show/camera/input.h"
#include "app/show/report/replay_report.h"
#include "app/show/request/requests.h"
#include "app/window/panel/controls/widgets.h"

namespace throng::app {

/// Shows a replay's place and outcome at the foot of the crowd, with its controls: play and pause, a frame back and on,
/// a track over all frames, loop, speed.
void show_replay_bar(Widgets& widgets, const Area& crowd, const ReplayReport& replay, Requests& requests);

/// Carries out the keys pressed in this frame for a replay: Space pauses, Left and Right go a frame back and on.
void apply_replay_keys(const InputFrame& input, Requests& requests);

}  // namespace throng::app
