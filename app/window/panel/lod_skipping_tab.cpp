// Level of detail by skipping updates: its rule, ways to look at it, and its cost, error and gain.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "app/settings/choices.h"
#include "app/window/panel/controls/plots.h"
#include "app/window/panel/tabs.h"

namespace throng::app {
namespace {

std::string milliseconds(float value) { return fixed(value, 2) + " ms"; }
std::string pixels(float value) { return fixed(value, 2) + " px"; }

void show_distances(const TabContext& context) {
  context.row("full_rate_distance", {.what = "Nearer agents are updated in every frame.",
                                     .unit = "metres from the camera",
                                     .cost = "Agents within it cost their full price."});
  context.row("interval_growth",
              {.what = "Beyond full rate, the interval grows by one frame with each such distance.", .unit = "metres"});
}

void show_limits(const TabContext& context) {
  context.row("error_px",
              {.what = "99% of the agents drawn are no farther than this from their exact pose, on the screen.",
               .unit = "pixels; none: the time limit alone counts",
               .cost = "A smaller limit costs more updates and more bones."});
  context.row("budget_ms",
              {.what = "Posing a frame takes no longer than this, as predicted, summed over all PUs. Agents on whom it "
                       "shows least lose detail first.",
               .unit = "milliseconds; none: as long as it takes"});
}

void show_what_binds(const TabContext& context) {
  context.widgets.fact(
      "Limited by", name_of(context.report.lod.binding),
      {.what = "error: the error limit decides. budget: the time limit does. both miss: neither can hold."});
  context.widgets.fact("Tolerance", pixels(context.report.lod.tolerance_px),
                       {.what = "In force now: each agent has the longest interval and the fewest bones that are "
                                "predicted to stay within it.",
                        .unit = "pixels"});
}

void show_rule(const TabContext& context) {
  context.widgets.section("Rule");
  context.row("lod",
              {.what = "off: every agent is updated in every frame, seen or not. distance: far agents are updated "
                       "less often. budget: each as seldom as the limits in pixels and milliseconds allow.",
               .cost = "off costs the most: the whole crowd in each frame."});
  show_limits(context);
  show_distances(context);
  context.row("largest_interval", {.what = "No agent waits longer for its next pose.",
                                   .unit = "frames, 1 to 16",
                                   .cost = "A longer interval costs less, until steps begin to show."});
  context.row("smooth",
              {.what = "The vertex shader blends from the pose shown now to one computed ahead, so that skipping does "
                       "not stutter.",
               .cost = "A second palette slot for each skipped agent."});
  if (context.tuning.lod.rule == LodRule::budget) context.when_not_searching(show_what_binds);
}

void show_looking(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  LodInspection& look = tuning.inspection;
  const LodInspection& plain = standard.inspection;
  widgets.section("Look");
  widgets.toggle("Freeze LOD camera", look.freeze_camera, plain.freeze_camera,
                 {.what = "Level of detail and culling go on from where the camera is now, and you fly on. What that "
                          "camera sees is drawn as lines."});
  context.unless_idle("thresholds", [&] {
    context.widgets.toggle(
        "Thresholds", look.thresholds, plain.thresholds,
        {.what = "Draws a ring on the ground wherever the interval changes, in that interval's colour. With the "
                 "rule budget they are for the clip that most agents in view play."});
  });
  widgets.toggle("Above heads", look.figures_above_heads, plain.figures_above_heads,
                 {.what = "Writes each agent's interval above its head, and after an L its bone level where bones are "
                          "dropped. The 300 tallest on the screen.",
                  .cost = "Drawing words; the animation is the same."});
  context.unless_idle("split", [&] {
    context.widgets.choice(
        "Split", look.split, plain.split, split_words,
        {.what = "Left of a line the exact crowd: all are posed now, with all bones and triangles. Right of it "
                 "the crowd as it is shown, or how far its picture is from the exact one, eight times as bright.",
         .cost = "All in view are posed once more in full, and drawn twice."});
  });
  context.unless_idle("split_at", [&] {
    context.widgets.number("Split at", look.split_at, plain.split_at, {.decimals = 2},
                           {.what = "Where the line is.", .unit = "of the picture's width"});
  });
}

void show_forcing(const TabContext& context) {
  context.widgets.section("Try");
  context.row("forced_interval", {.what = "All agents in view are updated this seldom, whatever the rule says.",
                                  .unit = "frames, 1 to 16; rule: as the rule has it"});
  show_forced_level(context, tuning_value("forced_bone_level").label,
                    "All agents in view keep the bones of this level. rule: as the rule says; 0: all bones.");
  context.row("force_selected_only", {.what = "The forced values are for the selected agent alone. Click at one."});
  context.widgets.caption("Hold X for the exact crowd.");
}

/// The interval at each distance, and the clip that it holds for where clips differ.
void show_intervals_over_distance(const TabContext& context) {
  const Tuning& tuning = context.tuning;
  const FrameReport& report = context.report;
  if (tuning.lod.rule == LodRule::off) return;
  constexpr float nearest_reach = 20, margin = 1.2F;
  const float reach = report.thresholds.empty() ? 0 : margin * report.thresholds.back().metres;
  context.widgets.section("Interval over distance");
  const Area plot = context.widgets.area("Interval over distance", 116);
  draw_steps(context.widgets.theme(), plot,
             {.longest = std::max(nearest_reach, reach),
              .largest = tuning.lod.largest_interval,
              .value_at = [&](float metres) { return interval_at(report.thresholds, metres); },
              .colour_of = [](int interval) { return colour::interval(interval); }});
  if (report.threshold_clip.empty()) return;
  context.widgets.caption("For " + report.threshold_clip + ", which most agents in view play, at " +
                          pixels(report.lod.tolerance_px) +
                          ": each clip has distances of its own. Rings show the same.");
}

void show_agents_by_interval(const TabContext& context) {
  std::vector<int> counts = context.report.agents_by_interval;
  const int largest = std::max(context.tuning.lod.largest_interval, static_cast<int>(counts.size()));
  counts.resize(static_cast<std::size_t>(largest), 0);
  context.widgets.section("Agents in view by interval");
  const Area plot = context.widgets.area("Agents by interval", 112);
  draw_bars(context.widgets.theme(), plot,
            {.counts = counts,
             .colour_of = [](int i) { return colour::interval(i + 1); },
             .name_of = [](int i) { return std::to_string(i + 1); }});
  double work = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) work += counts[i] / static_cast<double>(i + 1);
  const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
  if (all == 0) return;
  context.widgets.caption("On average " + with_thousands(std::lround(work)) + " poses a frame for " +
                          counted(static_cast<std::size_t>(all), "agent") + " in view: " + fixed(100 * work / all, 0) +
                          "% of the work without skipping.");
}

constexpr float smoothing = 0.08F;  // the share of a new frame in the curve, which follows in a dozen frames

std::vector<float> smoothed(const std::vector<float>& values) {
  std::vector<float> smooth(values);
  for (std::size_t i = 1; i < smooth.size(); ++i) smooth[i] = smooth[i - 1] + smoothing * (values[i] - smooth[i - 1]);
  return smooth;
}

void show_budget(const TabContext& context) {
  const FrameReport& report = context.report;
  Widgets& widgets = context.widgets;
  const Theme& theme = widgets.theme();
  widgets.section("Animation, a frame");
  Area graph = widgets.area("Budget graph", 96);
  graph.to.x -= theme.px(52);
  draw_well(theme, graph);
  const float limit = context.tuning.lod.rule == LodRule::budget ? context.tuning.budget_ms : 0;
  const float usual = report.update_ms_history.empty() ? 1 : at_percent(report.update_ms_history, 95);
  const float top = round_up(1.15F * std::max(usual, limit));
  const std::vector<float> smooth = smoothed(report.update_ms_history);
  draw_line(graph, report.update_ms_history, top, frames_shown, colour::with_alpha(colour::accent, 0.45F), theme.px(1));
  draw_line(graph, smooth, top, frames_shown, colour::accent, theme.px(2));
  std::vector<SideLabel> labels{{1, colour::faint, fixed(top, top < 1 ? 2 : 0) + " ms"}};
  if (limit > 0) labels.push_back(draw_limit(theme, graph, limit, top, milliseconds(limit)));
  draw_beside(theme, graph, labels);
  if (smooth.empty()) return;
  std::string words = "Measured, smoothed: " + milliseconds(smooth.back()) + ".";
  if (report.lod.predicted_ms > 0)
    words += " Predicted, over all PUs: " + milliseconds(static_cast<float>(report.lod.predicted_ms)) + ".";
  if (limit > 0) words += report.lod.budget_held ? " The limit holds." : " The limit does not hold.";
  widgets.caption(words);
}

void show_who_limits(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  widgets.section("What limits the frame rate");
  widgets.steady_caption(report.limit_sentence);
  TakenAway& away = tuning.taken_away;
  const TakenAway& all = standard.taken_away;
  const char* const cost = "Shows the frame rate without this part.";
  widgets.toggle("No animation", away.animation, all.animation, {.what = "Time stands still.", .cost = cost});
  widgets.toggle("No upload", away.upload, all.upload,
                 {.what = "The records of the last frame are drawn again.", .cost = cost});
  widgets.toggle("No drawing", away.drawing, all.drawing, {.what = "No draw call; the picture stays.", .cost = cost});
  context.unless_idle("pixels", [&] {
    context.widgets.toggle("No pixels", away.pixels, all.pixels,
                           {.what = "The crowd is drawn, and no pixel of it is filled.", .cost = cost});
  });
}

}  // namespace

void show_lod_skipping_tab(const TabContext& context) {
  show_rule(context);
  show_error(context);
  show_looking(context);
  show_forcing(context);
  context.when_not_searching(show_agents_by_interval);
  context.when_not_searching(show_intervals_over_distance);
  context.when_not_searching(show_budget);
  show_who_limits(context);
}

}  // namespace throng::app
