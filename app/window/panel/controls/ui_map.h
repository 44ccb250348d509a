#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/show/report/frame_report.h"

namespace throng::app {

/// The place of a widget, in pixels from the top left of the window.
struct UiRectangle {
  float x = 0, y = 0, width = 0, height = 0;
  bool takes_clicks = false;  ///< a click, a drag or typing does something there, unless it is idle
};

/// The places of all widgets and the state of the overlay, so that a program can drive it as a person would. Names are
/// the words on the screen: "Agents" is a value's slider, "Agents.field" the field to type into, "Agents.reset" its
/// arrow, "Schedule:levels" one of several choices, "tab:Crowd" a tab.
struct UiMap {
  int width = 0, height = 0;  ///< pixels of the picture that the overlay is laid out for
  std::string tab;
  bool hidden = false;                                       ///< the overlay is hidden, by Tab
  bool help = false;                                         ///< the help card is open, by F1
  bool shows_b = false;                                      ///< the second of two tunings is in use
  bool typing = false;                                       ///< keys go into a text field
  std::string focus;                                         ///< the widget that has the keyboard; empty: none
  std::vector<std::pair<std::string, UiRectangle>> widgets;  ///< the visible widgets, in drawing order
  std::vector<UiRectangle> over_crowd;                       ///< the cards, notices and bars that lie over the crowd
  std::vector<std::pair<std::string, std::string>> idle;     ///< rows that have no effect now, and why
};

/// Returns the map with the figures that tests wait for, as JSON: `size` [width, height], `tab`, `hidden`, `help`,
/// `shows_b`, `typing`, `focus`, `frame`, `tuning` {the keys of presets, `inspection`}, `report` {agents, drawn, pus,
/// tile, selected, ...}, `camera` {x, y, z, yaw, pitch, field_of_view}, `idle` {row: why it has no effect}, `widgets`
/// {name: {x, y, w, h}}.
std::string to_json(const UiMap& map, const Tuning& tuning, const FrameReport& report);

}  // namespace throng::app
