#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "app/overlay/widgets.h"
#include "app/report/frame_report.h"

namespace throng::app {

/// The newest frames, which graphs over frames show.
inline constexpr std::size_t frames_shown = 240;

/// A line over an area, 0 at the bottom and `highest` at the top: the last value at the right edge, one step of
/// `1 / (capacity - 1)` of the width a value.
void draw_line(const Area& area, std::span<const float> values, float highest, std::size_t capacity, ImU32 colour,
               float thickness);

/// A level line across the area with its words beside its right end.
void draw_limit(const Theme& theme, const Area& area, float value, float highest, const std::string& words);

/// Bars side by side; `count_of(i)` stands above, `name_of(i)` below. The space for names is inside the area.
struct Bars {
  std::span<const int> counts;
  std::function<ImU32(int)> colour_of;
  std::function<std::string(int)> name_of;
};
void draw_bars(const Theme& theme, const Area& area, const Bars& bars);

/// Steps upwards over a distance axis: `value_at(metres)`.
struct Steps {
  float longest = 100;  ///< metres at the right edge
  int largest = 1;      ///< value at the top
  std::function<int(float)> value_at;
  std::function<ImU32(int)> colour_of;
};
void draw_steps(const Theme& theme, const Area& area, const Steps& steps);

/// A rounded dark ground for a plot.
void draw_well(const Theme& theme, const Area& area);

/// The next larger of 1, 2, 5, 10, 20, 50...
float round_up(float value);

}  // namespace throng::app
