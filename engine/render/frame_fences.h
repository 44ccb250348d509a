#pragma once

#include <cstdint>
#include <deque>

#include <glad/gl.h>

namespace throng::render {

/// Says which drawn frames the device has finished reading, so that their palette slots can be written again. Frames
/// are counted by the caller, upwards.
class FrameFences {
 public:
  FrameFences() = default;
  FrameFences(const FrameFences&) = delete;
  FrameFences& operator=(const FrameFences&) = delete;
  ~FrameFences();

  /// After the last draw of `frame`, from 1. A frame may be drawn again: it is completed when that is.
  void insert(std::uint64_t frame);

  /// The newest completed frame, 0 when none is; never waits.
  std::uint64_t poll();

  /// Waits until `frame`, and with it all before it, is completed. GL thread, before animation starts.
  void wait(std::uint64_t frame);

  std::size_t frames_in_flight() const { return pending_.size(); }

 private:
  struct Pending {
    std::uint64_t frame;
    GLsync sync;
  };

  void complete_oldest();

  std::deque<Pending> pending_;
  std::uint64_t completed_ = 0;
};

}  // namespace throng::render
