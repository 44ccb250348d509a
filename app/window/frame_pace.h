#pragma once

#include <chrono>

namespace throng::app {

struct Tuning;

/// Sets the pace at which the frames of a window follow each other: that of the display, and a limit a second.
class FramePace {
 public:
  using Clock = std::chrono::steady_clock;

  /// Returns the time of a frame at the limit; 0 where there is none.
  static Clock::duration least_time(const Tuning& tuning);

  /// Ends a frame that began at `began`: waits until the limit allows the next one. From the next frame on the window
  /// follows the display as Tuning::vertical_sync says; the window's context must be current.
  void end_frame(Clock::time_point began, const Tuning& tuning);

 private:
  bool follows_display_ = true;  // a window is opened with it
};

}  // namespace throng::app
