#pragma once

#include <cstdint>
#include <deque>

#include <glad/gl.h>

namespace throng::render {

/// Says which frames the device has finished reading, so that their palette slots can be written again. The caller
/// numbers the frames, upwards.
class FrameFences {
 public:
  FrameFences() = default;
  FrameFences(const FrameFences&) = delete;
  FrameFences& operator=(const FrameFences&) = delete;
  ~FrameFences();

  /// Follows the last draw of `frame`, 1 or more. A frame may be drawn again; it is completed when its last draw is.
  void insert(std::uint64_t frame);

  /// Gives the newest completed frame, or 0 if there is none. Never waits.
  std::uint64_t poll();

  std::size_t frames_in_flight() const { return pending_.size(); }

 private:
  struct Pending {
    std::uint64_t frame;
    GLsync sync;
  };

  std::deque<Pending> pending_;
  std::uint64_t completed_ = 0;
};

}  // namespace throng::render
