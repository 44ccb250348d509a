#pragma once

#include "app/overlay/widgets.h"
#include "app/report/frame_report.h"
#include "app/settings/settings.h"

namespace throng::app {

/// What a tab reads and may change.
struct TabContext {
  Widgets& widgets;
  const FrameReport& report;
  Tuning& tuning;
  const Tuning& standard;  ///< the defaults to go back to
  OverlayCommands& commands;
};

/// Bone levels of the character shown: four, unless it has fewer.
int level_count(const FrameReport& report);

void show_crowd_tab(const TabContext& context);
void show_lod_skipping_tab(const TabContext& context);
/// Parts of it.
void show_lod_inspection(const TabContext& context);
void show_budget(const TabContext& context);
void show_error_on_screen(const TabContext& context);
void show_who_limits(const TabContext& context);

}  // namespace throng::app
