#include "app/show/figures/run_figures.h"

#include <chrono>

#include "app/show/stage/stage.h"

namespace throng::app {

void RunFigures::add_update(const Stage& stage, Clock::time_point start, double milliseconds) {
  times_.animation_ms = milliseconds;
  times_.stage = stage.times();
  if (timeline_) {
    const ErrorMeter& meter = stage.posed().error_meter();
    timeline_->add_update(stage.system(), start,
                          {.frame = stage.posed().frame(),
                           .agents_updated = stage.system().figures().report().agents_updated,
                           .update_ms = milliseconds,
                           .error_p99_px = meter.figures().p99,
                           .pop_px = meter.newest_pop()});
  }
  statistics_.add_update(milliseconds);
  statistics_.add_report(stage);
}

void RunFigures::add_overlay(double milliseconds) {
  const auto length =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double, std::milli>(milliseconds));
  if (timeline_) timeline_->add_overlay(Clock::now() - length, Clock::now());
  statistics_.add_overlay(milliseconds);
}

void RunFigures::add_drawing(Clock::time_point start, FrameTimes times, const render::DrawCounts& counts) {
  times.animation_ms = times_.animation_ms;
  times.stage = times_.stage;
  times_ = times;
  if (timeline_) timeline_->add_drawing(start, Clock::now());
  statistics_.set_draw(counts.draw_calls, counts.triangles);
  statistics_.add_drawn_frame(times.animation_ms + times.drawing_ms());
}

}  // namespace throng::app
