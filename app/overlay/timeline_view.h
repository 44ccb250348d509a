#pragma once

#include <deque>

#include "app/overlay/widgets.h"
#include "app/report/frame_report.h"

namespace throng::app {

/// What each PU did in the last frames, side by side on one axis of milliseconds. The wheel zooms about the pointer, a
/// drag moves along, a double click shows all again; the pointer over a span tells what it was.
class TimelineView {
 public:
  void show(Widgets& widgets, const std::deque<TimelineFrame>& frames);

  /// The part of the axis that is seen, in shares of all frames: 0 to 1.
  [[nodiscard]] float from() const { return from_; }
  [[nodiscard]] float to() const { return to_; }

 private:
  void zoom_and_move(const Area& axis);

  float from_ = 0, to_ = 1;
};

}  // namespace throng::app
