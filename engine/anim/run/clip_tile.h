#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/kernel/kernels.h"

namespace throng::anim {

/// What the characters of a tile show, for the kernel that poses the clips of all of them, packet by packet.
class ClipTile {
 public:
  void begin(std::size_t characters) {
    character_count_ = characters;
    clip_count_ = 0;
    displaced_quads_ = 0;
  }
  /// Where a character and those after it say what they show, and are then added.
  ShownClips* row(std::size_t first) { return &shown_[first]; }
  bool all_show(std::size_t first, std::size_t end) const {
    const auto shows = [](const ShownClips& shown) { return shown.clip != nullptr; };
    return std::ranges::all_of(std::span(shown_).subspan(first, end - first), shows);
  }
  void add(std::size_t first, std::size_t end) {
    std::size_t count = 0;
    std::uint64_t displaced = 0;  // not added up in memory
    for (const ShownClips& shown : std::span(shown_).subspan(first, end - first)) {
      if (shown.clip == nullptr) continue;
      ++count;
      displaced |= shown.clip->stream->displaced_quads;
      if (shown.blended != nullptr) displaced |= shown.blended->stream->displaced_quads;
    }
    clip_count_ += count;
    displaced_quads_ |= displaced;
  }
  bool empty() const { return clip_count_ == 0; }
  /// Those of which some position is not 0, as quads_of_packet reads them.
  std::uint64_t displaced_quads() const { return displaced_quads_; }

  /// But for what a packet adds.
  PoseClipsJob job(int components, float* local) const {
    return {.characters = std::span(shown_).first(character_count_), .components = components, .local = local};
  }

 private:
  std::array<ShownClips, widest_tile> shown_;
  std::size_t character_count_ = 0;
  std::size_t clip_count_ = 0;
  std::uint64_t displaced_quads_ = 0;
};

}  // namespace throng::anim
