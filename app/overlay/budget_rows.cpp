// What animation costs against what it may cost, and what that does to the picture.
#include <algorithm>
#include <vector>

#include "app/overlay/numbers.h"
#include "app/overlay/plots.h"
#include "app/overlay/tabs.h"

namespace throng::app {
namespace {

constexpr float smoothing = 0.08F;  // the share of a new frame: a dozen frames

std::vector<float> smoothed(const std::vector<float>& values) {
  std::vector<float> smooth(values);
  for (std::size_t i = 1; i < smooth.size(); ++i) smooth[i] = smooth[i - 1] + smoothing * (values[i] - smooth[i - 1]);
  return smooth;
}

float top_of(const FrameReport& report, float limit) {
  std::vector<float> values = report.update_ms_history;
  std::ranges::sort(values);
  const float usual = values.empty() ? 1 : values[(values.size() - 1) * 95 / 100];
  return round_up(1.15F * std::max(usual, limit));
}

std::string milliseconds(float value) { return fixed(static_cast<double>(value), 2) + " ms"; }
std::string pixels(float value) { return fixed(static_cast<double>(value), 2) + " px"; }

}  // namespace

void show_budget(const TabContext& context) {
  const FrameReport& report = context.report;
  Widgets& widgets = context.widgets;
  const Theme& theme = widgets.theme();
  widgets.section("Animation, a frame");
  Area graph = widgets.area("Budget graph", 96);
  graph.to.x -= theme.px(52);
  draw_well(theme, graph);
  const float limit = context.tuning.lod.rule == anim::LodRule::budget ? context.tuning.budget_ms : 0;
  const float top = top_of(report, limit);
  const std::vector<float> smooth = smoothed(report.update_ms_history);
  draw_line(graph, report.update_ms_history, top, frames_shown, colour::with_alpha(colour::accent, 0.45F), theme.px(1));
  draw_line(graph, smooth, top, frames_shown, colour::accent, theme.px(2));
  draw_text(theme.small, {graph.to.x + theme.px(6), graph.from.y - theme.px(2)}, colour::faint,
            fixed(static_cast<double>(top), top < 1 ? 2 : 0) + " ms");
  if (limit > 0) draw_limit(theme, graph, limit, top, milliseconds(limit));
  if (smooth.empty()) return;
  std::string words = "Measured, smoothed: " + milliseconds(smooth.back()) + ".";
  if (report.predicted_pose_ms > 0)
    words += " Predicted, over all PUs: " + milliseconds(report.predicted_pose_ms) + ".";
  if (limit > 0) words += report.budget_held ? " The limit holds." : " The limit does not hold.";
  widgets.caption(words);
}

void show_error_on_screen(const TabContext& context) {
  const FrameReport& report = context.report;
  if (report.error_samples == 0) return;
  Widgets& widgets = context.widgets;
  widgets.section("Error on the screen");
  widgets.fact("Half below", pixels(report.error_px_p50),
               {.what = "How far what is shown lies from the exact pose, the farthest point of each agent.",
                .unit = "pixels, over the last 60 frames"});
  widgets.fact("99% below", report.error_px_p99_is_known ? pixels(report.error_px_p99) : "too few samples",
               {.what = "Of all agents drawn, all but one in a hundred are nearer to their exact pose.",
                .unit = "pixels; shown from 1,000 samples on"});
  widgets.fact("Largest", pixels(report.error_px_max), {.what = "The worst of the last 60 frames.", .unit = "pixels"});
  widgets.fact(
      "Largest pop", pixels(report.pop_px_max),
      {.what = "How far that error jumped from one frame to the next: what the eye notices.", .unit = "pixels"});
}

void show_who_limits(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.section("Who limits you");
  if (!report.limit_sentence.empty()) widgets.caption(report.limit_sentence);
  TakenAway& away = tuning.taken_away;
  const TakenAway& all = standard.taken_away;
  const char* const cost = "Only to see what it costs: the frame rate without it.";
  widgets.toggle("No animation", away.animation, all.animation, {.what = "Time stands still.", .cost = cost});
  widgets.toggle("No upload", away.upload, all.upload,
                 {.what = "The records of the last frame are drawn again.", .cost = cost});
  widgets.toggle("No drawing", away.drawing, all.drawing, {.what = "No draw call; the picture stays.", .cost = cost});
  widgets.toggle("No pixels", away.pixels, all.pixels,
                 {.what = "The crowd is drawn, and no pixel of it is filled.", .cost = cost});
}

}  // namespace throng::app
