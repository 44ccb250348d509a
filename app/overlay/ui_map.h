#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/report/frame_report.h"

namespace throng::app {

/// Where a widget lies, in pixels from the top left of the window.
struct UiRectangle {
  float x = 0, y = 0, width = 0, height = 0;
};

/// Where everything of the overlay lies and what it is set to, so that a program can drive it as a person would.
/// Names are the words on the screen: "Agents" is a value's slider, "Agents.field" where it is typed, "Agents.reset";
/// "Schedule:levels" is one of several choices; "tab:Crowd" a tab.
struct UiMap {
  std::string tab;
  bool hidden = false;                                       ///< the overlay, by Tab
  bool help = false;                                         ///< the help card, by F1
  bool shows_b = false;                                      ///< of two tunings the second is in use
  bool typing = false;                                       ///< keys go into a text field
  std::vector<std::pair<std::string, UiRectangle>> widgets;  ///< those that can be seen, in drawing order

  [[nodiscard]] const UiRectangle* find(const std::string& name) const;
};

/// The map with the tuning and the figures that tests wait for, as JSON: `tab`, `hidden`, `help`, `shows_b`, `typing`,
/// `frame`, `tuning` {agents, paused, schedule, ...}, `report` {agents, drawn, pus, tile, selected, ...}, `camera` {x,
/// y, z, yaw, pitch, field_of_view}, `widgets` {name: {x, y, w, h}}.
std::string to_json(const UiMap& map, const Tuning& tuning, const FrameReport& report);

}  // namespace throng::app
