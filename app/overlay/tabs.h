#pragma once

#include "app/frame_report.h"
#include "app/overlay/widgets.h"
#include "app/settings.h"

namespace throng::app {

/// What a tab reads and may change.
struct TabContext {
  Widgets& widgets;
  const FrameReport& report;
  Tuning& tuning;
  const Tuning& standard;  ///< the defaults to go back to
  OverlayCommands& commands;
};

void show_crowd_tab(const TabContext& context);
void show_lod_skipping_tab(const TabContext& context);
void show_bone_lod_tab(const TabContext& context);
void show_scheduling_tab(const TabContext& context);

/// Frames between two updates of an agent, as the distance rule of the tuning gives them.
int interval_at(const Tuning& tuning, float metres);

}  // namespace throng::app
