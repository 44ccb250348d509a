#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/window/panel/controls/widgets.h"

namespace throng::app {

/// The number of frames that graphs over frames show, the newest.
inline constexpr std::size_t frames_shown = 240;

/// Draws a line over an area, 0 at the bottom and `highest` at the top. The last value lies at the right edge, and each
/// takes a step of `1 / (capacity - 1)` of the width.
void draw_line(const Area& area, std::span<const float> values, float highest, std::size_t capacity, ImU32 colour,
               float thickness);

/// Words beside the right edge of a plot.
struct SideLabel {
  float share = 0;  ///< of the plot's height, from the bottom, where their middle is wanted
  ImU32 ink = 0;
  std::string words;
};

/// Draws such labels, none over another.
void draw_beside(const Theme& theme, const Area& plot, std::span<const SideLabel> labels);

/// Draws a level line across the area, and returns the label that says what it is.
SideLabel draw_limit(const Theme& theme, const Area& area, float value, float highest, const std::string& words);

/// Bars side by side. The count stands above each, `name_of(i)` below, inside the area.
struct Bars {
  std::span<const int> counts;
  std::function<ImU32(int)> colour_of;
  std::function<std::string(int)> name_of;
};
void draw_bars(const Theme& theme, const Area& area, const Bars& bars);

/// A value in steps over a distance axis.
struct Steps {
  float longest = 100;  ///< metres at the right edge
  int largest = 1;      ///< value at the top
  std::function<int(float)> value_at;
  std::function<ImU32(int)> colour_of;
};
void draw_steps(const Theme& theme, const Area& area, const Steps& steps);

/// Draws a rounded dark ground for a plot.
void draw_well(const Theme& theme, const Area& area);

/// Returns the value that so many percent of the values do not exceed; 0 if there are none.
float at_percent(std::vector<float> values, std::size_t percent);

/// Returns the next larger of 1, 2, 5, 10, 20, 50...
float round_up(float value);

}  // namespace throng::app
