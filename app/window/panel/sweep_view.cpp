#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/settings/choices.h"
#include "app/window/panel/controls/plots.h"
#include "app/window/panel/tabs.h"
#include "engine/base/text/size_text.h"

namespace throng::app {
namespace {

constexpr float plot_height = 132, axis_width = 44, stop_margin = 18;

/// The unit that is written after a value, in the order of SweptValue.
constexpr std::array<const char*, 4> units = {" PUs", " KiB", " a tile", " \xC2\xB5s"};

std::string with_unit(SweptValue value, double number) {
  if (value == SweptValue::pus && number == 1.0) return "1 PU";
  return with_thousands(fixed(number, 0)) + units.at(static_cast<std::size_t>(value));
}

std::string as_milliseconds(double milliseconds) { return fixed(milliseconds, milliseconds < 10 ? 3 : 1) + " ms"; }

std::string in_three_digits(double number) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.3g", number);
  return text.data();
}

/// The value that the crowd is posed with; where the tuning says "automatic", the one that was chosen.
double in_force(SweptValue value, const FrameReport& report, const Tuning& tuning) {
  switch (value) {
    case SweptValue::pus:
      return tuning.system.pus == 0 ? report.hardware_threads : tuning.system.pus;
    case SweptValue::local_store:
      return static_cast<double>(tuning.system.local_store_bytes == 0 ? report.schedule.local_store_bytes
                                                                      : tuning.system.local_store_bytes) /
             static_cast<double>(bytes_a_kib);
    case SweptValue::tile:
      return tuning.system.tile == 0 ? report.schedule.plan.width : tuning.system.tile;
    case SweptValue::grain:
      break;
  }
  return swept_value(value, tuning);
}

/// The places in the plot: stops lie side by side, and times one above the other from 0 on.
struct Axes {
  Area plot;
  float pitch, margin;
  double highest;

  float x_of(std::size_t stop) const { return plot.from.x + margin + pitch * static_cast<float>(stop); }
  float y_of(double milliseconds) const {
    return plot.to.y - plot.height() * static_cast<float>(std::min(milliseconds / highest, 1.0));
  }
};

Axes axes_of(const Theme& theme, const Area& all, const SweepCurve& curve) {
  double highest = 0;
  for (const SweepStop& stop : curve.stops) highest = std::max(highest, stop.cost.milliseconds);
  const float line = font_height(theme.small) + theme.px(4);
  const Area plot{.from = {all.from.x + theme.px(axis_width), all.from.y + line},
                  .to = {all.to.x, all.to.y - line},
                  .hovered = all.hovered};
  const float margin = theme.px(stop_margin);
  return {.plot = plot,
          .pitch = (plot.width() - 2 * margin) / static_cast<float>(std::max<std::size_t>(curve.stops.size(), 2) - 1),
          .margin = margin,
          .highest = static_cast<double>(round_up(static_cast<float>(highest * 1.05)))};
}

/// The place of a value that need not be a stop: between the stops on both sides of it.
float x_between(const Axes& axes, const SweepCurve& curve, double value) {
  const auto after = std::ranges::lower_bound(curve.stops, value, {}, &SweepStop::value);
  if (after == curve.stops.begin()) return axes.x_of(0);
  if (after == curve.stops.end()) return axes.x_of(curve.stops.size() - 1);
  const auto before = std::prev(after);
  const double share = (value - before->value) / (after->value - before->value);
  const float x = axes.x_of(static_cast<std::size_t>(before - curve.stops.begin()));
  return x + axes.pitch * static_cast<float>(share);
}

void draw_axes(const Theme& theme, const Axes& axes) {
  draw_well(theme, axes.plot);
  for (const double share : {0.0, 0.5, 1.0}) {
    const float y = axes.y_of(share * axes.highest);
    ImGui::GetWindowDrawList()->AddLine({axes.plot.from.x, y}, {axes.plot.to.x, y}, colour::grid);
    draw_text(theme.small, {axes.plot.from.x - theme.px(6), y - font_height(theme.small) / 2}, colour::faint,
              share == 0 ? "0 ms" : in_three_digits(share * axes.highest), 1);
  }
}

void draw_in_force(const Theme& theme, const Axes& axes, float x) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float dash = theme.px(3);
  for (float y = axes.plot.from.y; y < axes.plot.to.y; y += 2 * dash) {
    draw.AddLine({x, y}, {x, std::min(y + dash, axes.plot.to.y)}, colour::changed);
  }
  const bool at_the_right = x > axes.plot.from.x + axes.plot.width() * 0.8F;
  const bool at_the_left = x < axes.plot.from.x + axes.plot.width() * 0.2F;
  draw_text(theme.small, {x, axes.plot.from.y - font_height(theme.small) - theme.px(2)}, colour::changed, "in force",
            at_the_right ? 1.0F : (at_the_left ? 0.0F : 0.5F));
}

void draw_curve(const Theme& theme, const Axes& axes, const SweepCurve& curve) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < curve.stops.size(); ++i) {
    const SweepStop& stop = curve.stops[i];
    if (stop.known && !stop.refused) draw.PathLineTo({axes.x_of(i), axes.y_of(stop.cost.milliseconds)});
  }
  draw.PathStroke(colour::accent, ImDrawFlags_None, theme.px(1.5F));
  for (std::size_t i = 0; i < curve.stops.size(); ++i) {
    const SweepStop& stop = curve.stops[i];
    draw_text(theme.small, {axes.x_of(i), axes.plot.to.y + theme.px(2)}, stop.refused ? colour::faint : colour::dim,
              stop.refused ? "\xE2\x80\x93" : fixed(stop.value, 0), 0.5F);
    if (!stop.known || stop.refused) continue;
    const ImVec2 at(axes.x_of(i), axes.y_of(stop.cost.milliseconds));
    const bool lowest = &stop == curve.lowest();
    draw.AddCircleFilled(at, theme.px(lowest ? 5.0F : 3.0F), lowest ? colour::text : colour::accent);
  }
}

const SweepStop* stop_under_pointer(const Axes& axes, const SweepCurve& curve) {
  if (!axes.plot.hovered) return nullptr;
  const float place = (ImGui::GetIO().MousePos.x - axes.x_of(0)) / std::max(axes.pitch, 1.0F);
  const long nearest = std::clamp(std::lround(place), 0L, static_cast<long>(curve.stops.size()) - 1);
  const SweepStop& stop = curve.stops[static_cast<std::size_t>(nearest)];
  return stop.known && !stop.refused ? &stop : nullptr;
}

// Enter takes the value of the lowest stop; left and right go to the stop before and after the one in force.
void take_by_keys(PanelFocus& focus, const SweepCurve& curve, Tuning& tuning) {
  const bool enters = focus.take_activation();
  const int step = focus.take_step();
  if (curve.runs || (!enters && step == 0)) return;
  const auto now = std::ranges::lower_bound(curve.stops, swept_value(curve.value, tuning), {}, &SweepStop::value);
  const auto last = static_cast<std::ptrdiff_t>(curve.stops.size()) - 1;
  const SweepStop* wanted = enters ? curve.lowest()
                                   : &curve.stops[static_cast<std::size_t>(
                                         std::clamp<std::ptrdiff_t>(now - curve.stops.begin() + step, 0, last))];
  if (wanted != nullptr && wanted->known && !wanted->refused) set_swept_value(curve.value, wanted->value, tuning);
}

void tell_of(const SweepCurve& curve, const SweepStop& stop) {
  show_lines({with_unit(curve.value, stop.value) + ": " + as_milliseconds(stop.cost.milliseconds),
              with_thousands(stop.cost.tasks) + " tasks, " + size_text(stop.cost.bytes) + " copied an update",
              curve.runs ? "" : "Click: take this value."});
}

std::string summary(const SweepCurve& curve) {
  if (curve.runs) {
    const int percent = 100 * curve.visits / std::max(curve.all_visits, 1);
    return "Sweeping, " + std::to_string(percent) + "% done. A change of any value ends it.";
  }
  const SweepStop* const lowest = curve.lowest();
  if (lowest == nullptr) return curve.visits > 0 || curve.refusal.empty() ? "Ended before anything was known." : "";
  return std::string(curve.complete() ? "" : "Ended early. ") + "Lowest: " + with_unit(curve.value, lowest->value) +
         ", " + as_milliseconds(lowest->cost.milliseconds) + " an update, " + with_thousands(lowest->cost.tasks) +
         " tasks, " + size_text(lowest->cost.bytes) + " copied.";
}

std::string refusals(const SweepCurve& curve) {
  std::string values;
  for (const SweepStop& stop : curve.stops) {
    if (stop.refused) values += (values.empty() ? "" : ", ") + with_unit(curve.value, stop.value);
  }
  return values.empty() ? "" : "Left out: " + values + ": " + curve.refusal;
}

void show_sweep_button(const TabContext& context) {
  const bool stands = context.tuning.paused || context.tuning.taken_away.animation;
  if (context.report.sweep.runs) {
    if (wide_button(context.widgets, "Stop", {.what = "The curve so far stays."})) context.requests.ask(StopSweep{});
  } else if (wide_button(
                 context.widgets, "Sweep",
                 {.what = "The crowd goes through the stops of that value, some frames at each, five rounds of all. "
                          "Then the value is as it was. Poses are the same throughout.",
                  .cost = "Some frames are slow meanwhile."},
                 stands ? "time stands still, so no agent is posed" : nullptr)) {
    context.requests.ask(StartSweep{context.memory.swept});
  }
}

}  // namespace

void show_sweep(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  const SweepCurve& curve = report.sweep;
  widgets.section("Sweep: what an update takes");
  widgets.begin_idle(curve.runs ? std::optional<std::string>("a sweep runs") : std::nullopt);
  widgets.choice("Vary", memory.swept, memory.swept, swept_value_words,
                 {.what = "What a sweep goes through, while all other values stay.",
                  .unit = "PUs: threads; store: KiB of each; tile: characters; grain: microseconds"});
  widgets.end_idle();
  if (widgets.is_searching()) return;
  show_sweep_button(context);
  if (curve.stops.empty()) return;
  const Theme& theme = widgets.theme();
  const Area area = widgets.area("Sweep curve", plot_height);
  const Axes axes = axes_of(theme, area, curve);
  draw_axes(theme, axes);
  draw_in_force(theme, axes, x_between(axes, curve, in_force(curve.value, report, tuning)));
  draw_curve(theme, axes, curve);
  take_by_keys(widgets.stop("Sweep curve", area), curve, tuning);
  if (const SweepStop* const stop = stop_under_pointer(axes, curve)) {
    tell_of(curve, *stop);
    if (!curve.runs && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) set_swept_value(curve.value, stop->value, tuning);
  }
  for (const std::string& line : {summary(curve), refusals(curve)}) {
    if (!line.empty()) widgets.caption(line);
  }
}

}  // namespace throng::app
