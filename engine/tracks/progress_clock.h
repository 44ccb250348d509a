#pragma once

#include <chrono>

#include "engine/tracks/reading.h"

namespace throng {

/// Tells progress at most some ten times a second. Belongs to one thread.
class ProgressClock {
 public:
  explicit ProgressClock(const ReadProgress& progress) : progress_(progress) {}

  void show(double share) {
    const auto now = std::chrono::steady_clock::now();
    if (!progress_ || now - last_ < std::chrono::milliseconds(90)) return;
    last_ = now;
    progress_(share);
  }
  void end() {
    if (progress_) progress_(1.0);
  }

 private:
  const ReadProgress& progress_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace throng
