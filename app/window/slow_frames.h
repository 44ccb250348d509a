#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <vector>

#include "app/show/report/frame_details.h"

namespace throng::app {

/// Keeps the slowest frames of the last seconds, so that a person who sees a spike can look at its frame. It keeps
/// `most_frames` of them at most, and the frame that a person looks at for as long as the look lasts.
class SlowFrames {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t most_frames = 16;
  static constexpr int frames_back = 240;  ///< as many as the graph over frames shows

  /// Takes a frame that has ended; their numbers ascend. Forgets frames that are too long ago, and then the fastest one
  /// where there are too many. `describe` is asked only if the frame is kept.
  void add(int number, float frame_ms, const std::function<FrameDetails()>& describe);
  /// Looks at the kept frame whose number is nearest. Nothing happens where none is kept.
  void look_at(int number);
  void look_at_last() { report_.looked_at.reset(); }

  const KeptFrames& report() const { return report_; }

 private:
  struct Kept {
    FrameDetails details;
    Clock::time_point ended;
  };

  void list_numbers();

  std::vector<Kept> kept_;  // by ascending number
  KeptFrames report_;
  Clock::time_point looked_at_ended_{};
};

}  // namespace throng::app
