#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/anim/run/update_report.h"

namespace throng::app {

/// Each PU's spans in one frame. Tasks too short to be told apart share a span.
struct TimelineFrame {
  int frame = 0;
  anim::UpdateTime time;                                 ///< makes milliseconds of the spans' ticks
  std::vector<std::vector<anim::TraceSpan>> lanes = {};  ///< [PU]
};

/// One PU in one frame.
struct PuReport {
  anim::PuActivity activity;
  std::size_t local_store_laid_out_bytes = 0;  ///< fetch buffers and scratch, as planned
};

/// All that is known of one frame's update.
struct FrameDetails {
  float frame_ms = 0, update_ms = 0;
  anim::UpdateReport work;
  std::vector<PuReport> pu;
  TimelineFrame timeline;  ///< has the frame's number

  int number() const { return timeline.frame; }
  std::uint64_t tiles() const {
    std::uint64_t sum = 0;
    for (const PuReport& each : pu) sum += each.activity.tasks;
    return sum;
  }
};

/// The frames that can be looked at after they have passed.
struct KeptFrames {
  std::vector<int> numbers;               ///< the frames that are kept, ascending
  std::optional<FrameDetails> looked_at;  ///< the one that a person looks at; nothing: the last ones
  float seconds_ago = 0;                  ///< since that one
};

}  // namespace throng::app
