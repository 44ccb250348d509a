#pragma once

#include <span>
#include <string>

#include "app/overlay/widgets.h"
#include "app/report/frame_report.h"

namespace throng::app {

/// The reason why an agent cannot be pushed over.
inline constexpr const char* cannot_fall = "it has fallen already, or its body is not known well enough";

/// Shows the strip below the crowd: the cost of the last frame, and of the frames before it. A click at one of these
/// looks at it.
void show_frame_strip(Widgets& widgets, const Area& place, const FrameReport& report, OverlayCommands& commands);

struct Notice {
  ImU32 colour = 0;
  std::string words;
};

/// Shows the notices at the top of the crowd, one below the other. Returns the y below the last of them.
float show_notices(const Widgets& widgets, const Area& crowd, std::span<const Notice> notices);

/// Shows the keys and the words, in the middle of the crowd.
void show_help_card(Widgets& widgets, const Area& crowd);

/// Shows what the selected agent does, and the graph of entities that makes its pose. The card is in the upper left of
/// `place`, where there is mostly sky.
void show_selection_card(Widgets& widgets, const Area& place, const SelectionReport& selected,
                         OverlayCommands& commands);

/// Returns the seconds of a player in its clip, such as "0.42 / 1.03"; nothing for other entities.
std::string place_in_clip(const EntityRow& row);

/// Writes the level of detail of each agent in the report above its head: the interval in frames, and after it the bone
/// level where bones are dropped.
void show_head_labels(Widgets& widgets, const Area& crowd, const FrameReport& report);

/// Begins a window of the overlay that stays in its place; end it with ImGui::End().
void begin_fixed_window(const char* name, const Area& place, float rounding = 0);

}  // namespace throng::app
