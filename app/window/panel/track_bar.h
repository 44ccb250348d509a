#pragma once

#include "app/show/camera/input.h"
#include "app/window/panel/tabs.h"

namespace throng::app {

/// Shows the timeline of a recorded crowd at the foot of the crowd: how many people are there over the file's time,
/// with a handle at the present time and one at each end of the part that is played. Below, its controls: a row back,
/// play backwards, play and pause, a row on, rate, loop, the whole file.
void show_track_bar(const TabContext& context, const Area& crowd);

/// Carries out the keys pressed in this frame for a recorded crowd: Left and Right go a row back and on, with Shift a
/// second, and pause; `[` and `]` begin and end the part that is played; Shift+Space plays the other way; Space at the
/// end begins anew. The caller handles Space as the pause before.
void apply_track_keys(const InputFrame& input, const TracksReport& tracks, Tuning& tuning, Requests& requests);

}  // namespace throng::app
