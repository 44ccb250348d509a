#pragma once

#include <cstddef>
#include <deque>
#include <string>

#include "throng/ticks.h"

#include "app/show/report/selection_report.h"

namespace throng::app {

class Stage;

/// Logs the selected agent since it was selected: its level of detail in each frame, and its events.
class SelectionLog {
 public:
  static constexpr std::size_t most_frames = 240, most_events = 32;

  /// Adds a frame to the log, and the log to the report of the selected agent. Call it once a frame, after the stage
  /// was posed. Allocates.
  void update(const Stage& stage, SelectionReport& selected);

 private:
  void begin(const Stage& stage, const SelectionReport& selected);
  void note(double seconds, const std::string& what);
  void note_data_keys(const Stage& stage);
  void note_clip(const Stage& stage);

  std::uint32_t agent_ = 0;
  std::uint64_t crowd_ = 0;
  Ticks seen_until_{};
  int clip_ = no_clip;
  std::deque<LodOfFrame> history_;
  std::deque<std::string> events_;  // the newest first
};

}  // namespace throng::app
