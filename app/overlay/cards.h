#pragma once

#include <span>
#include <string>

#include "app/overlay/widgets.h"
#include "app/report/frame_report.h"

namespace throng::app {

/// The strip below the crowd: what a frame costs now, and over the last frames.
void show_frame_strip(Widgets& widgets, const Area& place, const FrameReport& report);

struct Notice {
  ImU32 colour = 0;
  std::string words;
};

/// What there is to say, at the top of the crowd, one below the other. Where they end: the y of what may follow.
float show_notices(const Widgets& widgets, const Area& crowd, std::span<const Notice> notices);

/// The keys and the words, in the middle of the crowd.
void show_help_card(Widgets& widgets, const Area& crowd);

/// Starts a window of the overlay that stays where it is put; end it with ImGui::End().
void begin_fixed_window(const char* name, const Area& place, float rounding = 0);

}  // namespace throng::app
