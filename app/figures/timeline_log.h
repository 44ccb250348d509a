#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "engine/anim/agent/animation_system.h"

namespace throng::app {

/// Keeps what the newest frames of a run were spent on, for `--trace`: one lane for the frame, and one for each PU.
/// It has at most `most_spans` spans in all.
class TimelineLog {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t most_spans = 300'000;

  /// Takes what each PU did in an update, and a span around it from `frame_start` until now.
  void add_update(const anim::AnimationSystem& system, Clock::time_point frame_start);
  /// Takes a part of the newest frame that no PU did.
  void add_part(const char* name, Clock::time_point begin, Clock::time_point end);

  /// Returns a JSON object in the trace event format, which ui.perfetto.dev and chrome://tracing open. It has complete
  /// events (`X`) in microseconds since the first frame; copies have their bytes and transfers, tasks their agents.
  std::string to_json() const;

 private:
  struct Event {
    double begin_us;
    float length_us;
    std::uint32_t lane;  // 0: the frame; 1 + PU
    const char* name;
    std::uint32_t bytes_in = 0, bytes_out = 0, transfers = 0;
    anim::TaskContent content = {};
  };

  static void append_arguments(std::string& text, const Event& event);
  double since_start(Clock::time_point time) const;
  void add(const Event& event);

  Clock::time_point start_{};
  std::deque<std::vector<Event>> frames_;
  std::size_t spans_ = 0;
  std::uint32_t lanes_ = 1;
  std::uint64_t not_kept_ = 0;
};

}  // namespace throng::app
