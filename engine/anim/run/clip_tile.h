#pragma once

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
    displaced_packets_ = 0;
  }
  /// Where a character and those after it say what they show, and are then added.
  ShownClips* row(std::size_t first) { return &shown_[first]; }
  /// True: all of them show clips.
  bool add(std::size_t first, std::size_t end) {
    const std::size_t before = clip_count_;
    for (const ShownClips& shown : std::span(shown_).subspan(first, end - first)) {
      if (shown.clip == nullptr) continue;
      ++clip_count_;
      displaced_packets_ |= shown.clip->stream->displaced_packets;
      if (shown.blended != nullptr) displaced_packets_ |= shown.blended->stream->displaced_packets;
    }
    return clip_count_ - before == end - first;
  }
  bool empty() const { return clip_count_ == 0; }
  /// Some position of the packet is not 0.
  bool displaced(int packet) const { return (displaced_packets_ >> static_cast<unsigned>(packet) & 1U) != 0; }

  PoseClipsJob job(int packet, int components, bool displaced, float* local) const {
    return {.characters = std::span(shown_).first(character_count_),
            .packet = packet,
            .components = components,
            .displaced = displaced,
            .local = local};
  }

 private:
  std::array<ShownClips, widest_tile> shown_;
  std::size_t character_count_ = 0;
  std::size_t clip_count_ = 0;
  std::uint64_t displaced_packets_ = 0;
};

}  // namespace throng::anim
