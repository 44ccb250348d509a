// The error on the screen: its figures with their chance intervals, and their history beside the limit.
#include <algorithm>
#include <string>
#include <vector>

#include "app/window/panel/controls/plots.h"
#include "app/window/panel/tabs.h"
#include "engine/crowd/error_history.h"

namespace throng::app {
namespace {

constexpr float least_top = 0.25F;  // pixels, of the graph

std::string length_on_screen(float value) { return fixed(value, 2) + " px"; }

// Without a sample there is no figure; the reason stands below.
std::string figure(const anim::ErrorFigures& figures, float value) {
  return figures.samples == 0 ? "none yet" : length_on_screen(value);
}

std::string with_interval(const anim::ErrorFigures& figures, float value, const anim::QuantileInterval& interval) {
  if (figures.samples == 0) return figure(figures, value);
  const std::string ends =
      interval.high ? fixed(interval.low, 2) + " to " + fixed(*interval.high, 2) : fixed(interval.low, 2) + " or more";
  return length_on_screen(value) + " (" + ends + ")";
}

constexpr const char* chance =
    "In brackets: where it lies for all in view with a confidence of 95%, since only some are measured. It counts the "
    "samples on either side and takes each as drawn by chance; those of one agent in frames that follow each other are "
    "alike, so it is a little too narrow.";

void show_error_figures(Widgets& widgets, const ErrorReport& error) {
  const anim::ErrorFigures& figures = error.figures;
  widgets.fact("p50", with_interval(figures, figures.p50, error.intervals.p50),
               {.what = "Half of the agents in view are nearer to their exact pose, at the point of them that is "
                        "farthest off.",
                .unit = "pixels on the screen, over the last 60 frames or more",
                .cost = chance});
  widgets.fact("p99", with_interval(figures, figures.p99, error.intervals.p99),
               {.what = "All but one in a hundred are nearer to their exact pose. The error limit is about this one.",
                .unit = "pixels on the screen, over the last 60 frames or more",
                .cost = chance});
  widgets.fact("Maximum", figure(figures, figures.max),
               {.what = "The worst of those measured in the last 60 frames.", .unit = "pixels on the screen"});
  widgets.fact("Pop", figure(figures, figures.pop_max),
               {.what = "The farthest that an error jumped from one frame to the next: what the eye notices.",
                .unit = "pixels on the screen, in the last 60 frames"});
  widgets.fact("Samples", with_thousands(figures.samples) + " in " + with_thousands(figures.frames) + " frames",
               {.what = "An agent measured in a frame. They reach back over 60 frames, and up to 600 until there are "
                        "1,000 of them, which the error limit learns from."});
}

void show_error_history(Widgets& widgets, const ErrorReport& error, float limit) {
  const Theme& theme = widgets.theme();
  Area graph = widgets.area("Error history", 84);
  graph.to.x -= theme.px(52);
  draw_well(theme, graph);
  const auto most = [](const std::vector<float>& values) {
    return values.empty() ? 0.0F : *std::ranges::max_element(values);
  };
  const float seen = std::max({most(error.p99_history), at_percent(error.pop_history, 98), limit, least_top});
  const float top = round_up(1.15F * seen);
  draw_line(graph, error.pop_history, top, ErrorHistory::most_values, colour::with_alpha(colour::frame, 0.6F),
            theme.px(1));
  draw_line(graph, error.p99_history, top, ErrorHistory::most_values, colour::accent, theme.px(2));
  std::vector<SideLabel> labels{{1, colour::faint, fixed(top, top < 1 ? 2 : 0) + " px"},
                                {0.01F, colour::accent, "p99"},
                                {0, colour::frame, "pop"}};
  if (limit > 0) labels.push_back(draw_limit(theme, graph, limit, top, "limit"));
  draw_beside(theme, graph, labels);
}

const char* why_no_figures(const TabContext& context) {
  if (context.tuning.error_sample == ErrorSampling::off && context.tuning.debug_view != DebugView::error) {
    return "No agent is measured: Measure is off.";
  }
  return context.report.visible == 0 ? "No agent is in view." : "No agent in view has been posed twice yet.";
}

}  // namespace

void show_error(const TabContext& context) {
  const ErrorReport& error = context.report.error;
  context.widgets.section("Error on the screen");
  context.row(
      "error_sample",
      {.what = "Whose error is measured. some: a sample of the agents on whom it shows, and a larger share of a small "
               "crowd. all: all in view. off: none, so the error limit learns nothing.",
       .cost = "some: 5% of the animation, or four agents a frame. all: more than the animation itself."});
  if (context.widgets.is_searching()) return;
  show_error_figures(context.widgets, error);
  show_error_history(context.widgets, error, context.tuning.lod.rule == LodRule::budget ? context.tuning.error_px : 0);
  context.widgets.steady_caption(error.figures.samples == 0 ? why_no_figures(context) : error.skipping_sentence);
}

}  // namespace throng::app
