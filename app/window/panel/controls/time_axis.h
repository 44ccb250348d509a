#pragma once

#include <string>

#include "app/window/panel/controls/widgets.h"

namespace throng::app {

/// Returns "12.40 s".
inline std::string seconds_text(double seconds) { return fixed(seconds, 2) + " s"; }

/// An axis of seconds across the screen. Where it has no length, every time lies at its left end.
struct TimeAxis {
  float from = 0, to = 1;          ///< pixels
  double first = 0.0, last = 0.0;  ///< seconds there

  [[nodiscard]] float x_of(double seconds) const;
  /// Returns the time at a pixel, or at the nearer end.
  [[nodiscard]] double time_at(float x) const;
  /// Writes round times below a graph, in at most 16 pixels, with lines up through it.
  void draw_labels(const Theme& theme, const Area& graph) const;
};

}  // namespace throng::app
