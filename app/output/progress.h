#pragma once

#include <chrono>
#include <string>

#include "app/files/progress_bar.h"

namespace throng::app {

/// Counts the frames of a run without a window. On a terminal it shows how far the run is and how long it goes on, once
/// that takes longer than `not_long`. For another program it says that in lines. Elsewhere it shows nothing.
class Progress {
 public:
  /// `frames` is the length of the run; 0 where it is not known.
  explicit Progress(int frames, bool says_lines = false, std::chrono::milliseconds not_long = std::chrono::seconds(2))
      : frames_(frames), says_lines_(says_lines), bar_(not_long) {}

  void show(int frame);
  /// Clears the line, for other output.
  void end() { bar_.show(0, ""); }
  /// Returns the frame that was shown last.
  int frame() const { return frame_; }
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  int frames_, frame_ = 0;
  bool says_lines_;
  double said_at_ = -1.0;  // seconds
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  ProgressBar bar_;
};

/// Returns "frame 30 of 600, 2.4 a second, 3 min 58 s left".
std::string progress_text(int frame, int frames, double seconds);

/// Returns a time for people: "4.2 s", "38 s", "3 min 58 s", "2 h 5 min".
std::string time_text(double seconds);

}  // namespace throng::app
