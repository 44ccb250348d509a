#pragma once

#include <chrono>
#include <string>

namespace throng::app {

/// Shows on a terminal how far a run is and how long it goes on, a few times a second. Elsewhere it shows nothing.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// `frames` is the length of the run; 0 where it is not known.
  explicit Progress(int frames);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(int frame);
  /// Clears the line, for other output.
  void end();
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  int frames_;
  bool has_line_ = false;
  Clock::time_point start_ = Clock::now(), told_ = start_;
};

/// Returns "frame 30 of 600, 2.4 a second, 3 min 58 s left".
std::string progress_text(int frame, int frames, double seconds);

/// Returns a time for people: "4.2 s", "38 s", "3 min 58 s", "2 h 5 min".
std::string time_text(double seconds);

}  // namespace throng::app
