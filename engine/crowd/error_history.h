#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace throng {

/// The errors on screen of a frame.
struct ErrorOfFrame {
  float p99 = 0;  ///< pixels, over the frames that ErrorWindow::figures looks at
  float pop = 0;  ///< pixels, the largest of this frame
};

/// Keeps the errors of the last 480 frames, one value for two frames, for a graph. Allocates nothing.
class ErrorHistory {
 public:
  static constexpr std::size_t most_values = 240, frames_a_value = 2;

  void add(const ErrorOfFrame& frame) {
    const bool is_new = frames_++ % frames_a_value == 0;
    if (is_new && count_ == most_values) {
      std::shift_left(p99_.begin(), p99_.end(), 1);
      std::shift_left(pop_.begin(), pop_.end(), 1);
    } else if (is_new) {
      ++count_;
    }
    p99_[count_ - 1] = frame.p99;
    pop_[count_ - 1] = is_new ? frame.pop : std::max(pop_[count_ - 1], frame.pop);
  }

  /// Returns the last p99 of each two frames, oldest first.
  std::span<const float> p99() const { return std::span(p99_).first(count_); }
  /// Returns the largest pop of each two frames, oldest first.
  std::span<const float> pop() const { return std::span(pop_).first(count_); }

 private:
  std::array<float, most_values> p99_{}, pop_{};
  std::size_t count_ = 0;
  std::size_t frames_ = 0;
};

}  // namespace throng
