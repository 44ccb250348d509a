#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace throng::app {

/// Shows a bar on a terminal while long work runs: its share and its step. Work that ends within `not_long` shows none,
/// and without a terminal there is none.
class ProgressBar {
 public:
  explicit ProgressBar(std::chrono::milliseconds not_long = std::chrono::milliseconds(500));
  /// Clears the line.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Returns whether there is a terminal to show it on.
  bool is_there() const { return shows_.joinable(); }
  /// Names the step that begins now. `share` of 0 to 1 is done; below 0 it is not known, and the step alone is shown.
  /// Nothing is shown while `what` is empty, for other output. Any thread may call it.
  void show(double share, std::string what);

 private:
  void show_after(std::chrono::milliseconds not_long);

  std::mutex mutex_;
  std::condition_variable ended_;
  double share_ = 0;
  std::string what_;
  bool is_shown_ = false, has_ended_ = false;
  std::thread shows_;
};

/// Returns "[=======             ] Knight.glb, clip 26 of 76"; the text alone where the share is below 0.
std::string bar_text(double share, const std::string& what);

}  // namespace throng::app
