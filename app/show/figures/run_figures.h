#pragma once

#include <optional>

#include "throng/render/crowd_draw.h"

#include "app/show/figures/limiter.h"
#include "app/show/figures/statistics.h"
#include "app/show/figures/timeline_log.h"

namespace throng::app {

/// Measures a run: the times and costs of its frames, and the work of each PU in them.
class RunFigures {
 public:
  using Clock = TimelineLog::Clock;

  /// Keeps the work of each PU from now on, for `--trace`.
  void keep_timeline() { timeline_.emplace(); }
  /// Returns the times of the start, to be written.
  StartTimes& start() { return statistics_.start; }
  /// Takes the time of laying out the overlay in this frame; call it when the overlay is laid out.
  void add_overlay(double milliseconds);
  /// Takes an update that began at `start` and posed the crowd in `milliseconds`.
  void add_update(const Stage& stage, Clock::time_point start, double milliseconds);
  /// Takes a drawing that began at `start`; `times` has all of its parts but the animation.
  void add_drawing(Clock::time_point start, FrameTimes times, const render::DrawCounts& counts);

  const Statistics& statistics() const { return statistics_; }
  /// Returns nothing unless keep_timeline() was called.
  const std::optional<TimelineLog>& timeline() const { return timeline_; }
  /// Returns the times of the last frame.
  const FrameTimes& times() const { return times_; }

 private:
  Statistics statistics_;
  std::optional<TimelineLog> timeline_;
  FrameTimes times_;
};

}  // namespace throng::app
