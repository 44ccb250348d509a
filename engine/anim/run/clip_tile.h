#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/anim/entity/entity_run.h"
#include "engine/anim/kernel/kernels.h"

namespace throng::anim {

/// The characters of a tile that show clips, which one call of a kernel poses packet by packet.
class ClipTile {
 public:
  void clear() {
    clip_count_ = 0;
    blended_count_ = 0;
    displaced_packets_ = 0;
  }
  void add(int character, const ShownClips& shown) {
    clips_[clip_count_++] = moment(character, *shown.clip, 0.0F);
    if (shown.blended != nullptr) blended_[blended_count_++] = moment(character, *shown.blended, shown.fraction);
  }
  bool empty() const { return clip_count_ == 0; }
  std::size_t size() const { return clip_count_; }
  /// Some position of the packet is not 0.
  bool displaced(int packet) const { return (displaced_packets_ >> static_cast<unsigned>(packet) & 1U) != 0; }

  PoseClipsJob job(int packet, int components, bool displaced, float* local) const {
    return {.clips = std::span(clips_).first(clip_count_),
            .blended = std::span(blended_).first(blended_count_),
            .packet = packet,
            .components = components,
            .displaced = displaced,
            .local = local};
  }

 private:
  using Moments = std::array<ClipMoment, widest_tile>;

  ClipMoment moment(int character, const ShownClip& shown, float fraction) {
    displaced_packets_ |= shown.stream->displaced_packets;
    return {.stream = shown.stream, .point = shown.point, .character = character, .fraction = fraction};
  }

  Moments clips_, blended_;
  std::size_t clip_count_ = 0;
  std::size_t blended_count_ = 0;
  std::uint64_t displaced_packets_ = 0;
};

}  // namespace throng::anim
