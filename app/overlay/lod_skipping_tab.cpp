#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/overlay/numbers.h"
#include "app/overlay/plots.h"
#include "app/overlay/tabs.h"
#include "app/settings/choices.h"

namespace throng::app {
namespace {

void show_distances(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.number("Full rate until", tuning.lod.full_rate_distance, standard.lod.full_rate_distance,
                 scale_of("full_rate_distance"),
                 {.what = "Nearer agents are updated in every frame.",
                  .unit = "metres from the camera",
                  .cost = "Agents within it cost their full price."});
  widgets.number("One more each", tuning.lod.interval_growth, standard.lod.interval_growth, scale_of("interval_growth"),
                 {.what = "Beyond that, the interval grows by one frame with each such distance.", .unit = "metres"});
}

void show_limits(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.number("Error limit", tuning.error_px, standard.error_px, scale_of("error_px"),
                 {.what = "99% of the agents drawn are no farther than this from their exact pose, on the screen.",
                  .unit = "pixels; none: as far as the time limit asks",
                  .cost = "The fewer, the more updates and bones."});
  widgets.number(
      "Time limit", tuning.budget_ms, standard.budget_ms, scale_of("budget_ms"),
      {.what = "All poses of a frame take no longer, over all PUs, by prediction. Those are degraded first on "
               "whom it is seen least.",
       .unit = "milliseconds; none: as long as it takes"});
  if (report.binding_limit.empty()) return;
  widgets.fact("Limited by", report.binding_limit,
               {.what = "error: the error limit decides. budget: the time limit does. both miss: neither can hold."});
  widgets.fact("Tolerance", fixed(static_cast<double>(report.lod_tolerance_px), 2) + " px",
               {.what = "In force now: each agent has the longest interval and the fewest bones that are predicted to "
                        "stay within it.",
                .unit = "pixels"});
}

void show_rule(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.section("Rule");
  widgets.choice("Rule", tuning.lod.rule, standard.lod.rule, lod_rule_words,
                 {.what = "off: every agent is updated in every frame, seen or not. distance: the farther, the rarer. "
                          "budget: as rarely as pixels and milliseconds allow.",
                  .cost = "off is the full price of the crowd."});
  ImGui::BeginDisabled(tuning.lod.rule == anim::LodRule::off);
  if (tuning.lod.rule == anim::LodRule::budget) {
    show_limits(context);
  } else {
    show_distances(context);
  }
  widgets.number("Largest interval", tuning.lod.largest_interval, standard.lod.largest_interval,
                 scale_of("largest_interval"),
                 {.what = "No agent waits longer for its next pose.",
                  .unit = "frames, 1 to 16",
                  .cost = "Cost falls with it, until steps begin to show."});
  widgets.toggle(
      "Smooth", tuning.lod.smooth, standard.lod.smooth,
      {.what = "The vertex shader blends from the pose shown now to one computed ahead, so that skipping does "
               "not stutter.",
       .cost = "A second palette slot for each skipped agent."});
  ImGui::EndDisabled();
}

/// At which distances, and of whom where that is not the same for all.
void show_intervals_over_distance(const TabContext& context) {
  const Tuning& tuning = context.tuning;
  const FrameReport& report = context.report;
  if (tuning.lod.rule == anim::LodRule::off) return;
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
  context.widgets.caption("Of " + report.threshold_clip + ", which most of those in view play, at " +
                          fixed(static_cast<double>(report.lod_tolerance_px), 2) +
                          " px: each clip has distances of its own. Rings show the same.");
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
  context.widgets.caption("On average " + fixed(work, 0) + " poses a frame for " + fixed(all, 0) +
                          " agents in view: " + fixed(100 * work / all, 0) + "% of the work without skipping.");
}

}  // namespace

void show_lod_skipping_tab(const TabContext& context) {
  show_rule(context);
  show_lod_inspection(context);
  show_agents_by_interval(context);
  show_intervals_over_distance(context);
  show_budget(context);
  show_error_on_screen(context);
  show_who_limits(context);
}

}  // namespace throng::app
