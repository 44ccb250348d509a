#include "app/figures/run_figures.h"

namespace throng::app {

void RunFigures::add_update(const Stage& stage, Clock::time_point start, double milliseconds) {
  times_.animation_ms = milliseconds;
  if (timeline_) timeline_->add_update(stage.system(), start);
  statistics_.add_update(milliseconds);
  statistics_.add_report(stage);
}

void RunFigures::add_drawing(Clock::time_point start, FrameTimes times, const render::DrawCounts& counts) {
  times.animation_ms = times_.animation_ms;
  times_ = times;
  if (timeline_) timeline_->add_part("draw", start, Clock::now());
  statistics_.set_draw(counts.draw_calls, counts.triangles);
  statistics_.add_drawn_frame(times.animation_ms + times.drawing_ms());
}

}  // namespace throng::app
