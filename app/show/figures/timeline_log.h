#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "engine/anim/run/program/task_content.h"

namespace throng::anim {
class AnimationSystem;
}

namespace throng::app {

/// The figures of a frame that a trace draws as curves.
struct TraceCounters {
  std::uint64_t frame = 0;  ///< its number, from 1
  std::uint32_t agents_updated = 0;
  double update_ms = 0;
  float error_p99_px = 0, pop_px = 0;  ///< over the last 60 frames; of this frame
};

/// Keeps the work of the newest frames of a run, for `--trace`: a lane for updates, one for each PU, and where there
/// are any, one for drawing and one for the overlay. It has at most `most_spans` spans and figures in all.
class TimelineLog {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t most_spans = 300'000;

  /// Takes the work of each PU in an update, and a span around it from `frame_start` until now.
  void add_update(const anim::AnimationSystem& system, Clock::time_point frame_start,
                  const TraceCounters& counters = {});
  /// Takes the drawing of the newest frame.
  void add_drawing(Clock::time_point begin, Clock::time_point end) { add_part(drawing_lane, begin, end); }
  /// Takes the laying out of the overlay, after the newest frame.
  void add_overlay(Clock::time_point begin, Clock::time_point end) { add_part(overlay_lane, begin, end); }

  /// Returns a JSON object in the trace event format, which ui.perfetto.dev and chrome://tracing open. It has complete
  /// events (`X`) in microseconds since the first frame; copies have their bytes and transfers, tasks their agents, and
  /// updates, drawing and overlay the number of their frame. Counters (`C`) have the figures of each frame.
  std::string to_json() const;

 private:
  struct Event {
    double begin_us;
    float length_us;
    std::uint32_t lane;  // 0: updates; 1 + PU; or one of the two below
    const char* name;
    std::uint32_t bytes_in = 0, bytes_out = 0, transfers = 0;
    anim::TaskContent content = {};
  };

  struct Frame {
    double begin_us = 0;
    TraceCounters counters;
    std::vector<Event> events;

    std::size_t size() const { return events.size() + counters_a_frame; }
  };
  static constexpr std::uint32_t drawing_lane = 10'000, overlay_lane = drawing_lane + 1;  // behind the lanes of all PUs
  static constexpr std::size_t counters_a_frame = 4;

  static void append_arguments(std::string& text, const Event& event);
  static void append_event(std::string& text, const Event& event, std::uint64_t frame);
  static void append_counters(std::string& text, const Frame& frame);
  void append_lane_names(std::string& text) const;
  void add_part(std::uint32_t lane, Clock::time_point begin, Clock::time_point end);
  double since_start(Clock::time_point time) const;
  void add(const Event& event);

  Clock::time_point start_{};
  std::deque<Frame> frames_;
  std::size_t spans_ = 0;
  std::uint32_t lanes_ = 1;
  bool draws_ = false, has_overlay_ = false;
  std::uint64_t not_kept_ = 0;
};

}  // namespace throng::app
