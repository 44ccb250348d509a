#pragma once

#include "app/report/frame_report.h"
#include "app/settings/settings.h"
#include "app/view/input.h"

namespace throng::app {

/// What the keys open and close in the overlay.
struct OverlaySwitches {
  bool hidden = false;
  bool help = false;
};

/// Does what the keys pressed in this frame ask for: Space pause, Tab hide, F1 help, F frame crowd, C copy camera,
/// R begin or end a recording, F5 build the shaders again, F12 screenshot, X while held the exact crowd; with somebody
/// selected P pushes over and Esc deselects, else Esc quits. Not to be called while a text field has the keys.
void apply_hotkeys(const InputFrame& input, bool anybody_selected, OverlaySwitches& switches, Tuning& tuning,
                   OverlayCommands& commands);

}  // namespace throng::app
