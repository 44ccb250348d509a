#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/kernel/kernels.h"

namespace throng::anim {

/// The clips that the characters of a strip show, for the kernel that poses all of them, packet by packet.
class ClipStrip {
 public:
  /// Begins a strip. `shown` is [character], where callers write a character's clips before they add it.
  void begin(std::span<ShownClips> shown) {
    shown_ = shown;
    clip_count_ = 0;
    displaced_quads_ = 0;
  }
  ShownClips& of(std::size_t character) const { return shown_[character]; }
  bool all_show(std::size_t first, std::size_t end) const {
    const auto shows = [](const ShownClips& shown) { return shown.clip != nullptr; };
    return std::ranges::all_of(shown_.subspan(first, end - first), shows);
  }
  void add(std::size_t first, std::size_t end) {
    std::size_t count = 0;
    std::uint64_t displaced = 0;  // added up in a register, not in memory
    for (const ShownClips& shown : shown_.subspan(first, end - first)) {
      if (shown.clip == nullptr) continue;
      ++count;
      displaced |= shown.clip->stream->displaced_quads;
      if (shown.blended != nullptr) displaced |= shown.blended->stream->displaced_quads;
    }
    clip_count_ += count;
    displaced_quads_ |= displaced;
  }
  bool empty() const { return clip_count_ == 0; }
  /// Returns the quads in which some position is not 0, as quads_of_packet reads them.
  std::uint64_t displaced_quads() const { return displaced_quads_; }

  /// Returns the job of the kernel, without the packet and its displaced quads.
  PoseClipsJob job(int components, float* local) const {
    return {.characters = shown_, .components = components, .local = local};
  }

 private:
  std::span<ShownClips> shown_;
  std::size_t clip_count_ = 0;
  std::uint64_t displaced_quads_ = 0;
};

}  // namespace throng::anim
