#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace throng::app {

/// Shows a bar on a terminal while a long start runs: its share and its step. A start of less than half a second shows
/// none, and without a terminal there is none.
class StartLine {
 public:
  StartLine();
  /// Clears the line.
  ~StartLine();
  StartLine(const StartLine&) = delete;
  StartLine& operator=(const StartLine&) = delete;

  /// Names the step that begins now. `share` of 0 to 1 is done. Nothing is shown while `what` is empty, for other
  /// output. Any thread may call it.
  void show(double share, std::string what);

 private:
  void show();

  std::mutex mutex_;
  std::condition_variable ended_;
  double share_ = 0;
  std::string what_;
  bool is_shown_ = false, has_ended_ = false;
  std::thread shows_;
};

/// Returns "[=======             ] Knight.glb, clip 26 of 76".
std::string bar_text(double share, const std::string& what);

}  // namespace throng::app
