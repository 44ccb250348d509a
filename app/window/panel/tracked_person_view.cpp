#include "app/window/panel/tracked_person_view.h"

#include <algorithm>
#include <cmath>

#include "app/settings/choices.h"
#include "app/window/panel/controls/plots.h"
#include "app/window/panel/controls/time_axis.h"

namespace throng::app {
namespace {

constexpr float line_height = 18, steps_height = 24, axis_height = 16, letter_width = 12;
constexpr float slow_steps = 0.1F;       // metres a second, of a person who does not quite stand
constexpr float least_speed_top = 1.5F;  // metres a second at the top of the graph

// Without "-0.00".
std::string place_text(double metres) { return fixed(std::round(metres * 100.0) / 100.0 + 0.0, 2); }

std::string where_words(const SelectionReport& selected, double now) {
  const TrackedPerson& person = *selected.tracked;
  const Presence& presence = person.presence;
  const std::string there = "there from " + fixed(presence.first, 2) + " to " + seconds_text(presence.last) + ", " +
                            counted(person.rows, "row");
  const std::string tall = fixed(person.stature, 2) + " m tall";
  if (!presence.has(now)) return there + "   " + tall;
  return "x " + place_text(person.origin.x + static_cast<double>(selected.x)) + ", y " +
         place_text(person.origin.y - static_cast<double>(selected.z)) + " m   " + there + "   " + tall;
}

std::string way_words(const TrackedPerson& person, double now) {
  const double time = person.presence.last - person.presence.first;
  const float way = person.ways.back();
  std::string words = fixed(person.speed_at(now), 2) + " m/s";
  if (!person.presence.has(now)) words = "not there";
  words += "   walked " + fixed(person.way_at(now), 1) + " of " + fixed(way, 1) + " m";
  if (time > 0.0) words += ", " + fixed(static_cast<double>(way) / time, 2) + " m/s on average";
  if (!person.has_all_footfalls) return words + "   the steps are being counted";
  return words + "   " + with_thousands(person.steps_until(now)) + " of " + with_thousands(person.footfalls.size()) +
         " steps";
}

void draw_speeds(const Theme& theme, const Area& graph, const TimeAxis& axis, const TrackedPerson& person) {
  const float top = round_up(std::max(person.fastest(), least_speed_top));
  draw_well(theme, graph);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto points = static_cast<int>(std::clamp(graph.width(), 2.0F, 4096.0F));
  for (int i = 0; i < points; ++i) {
    const float x = graph.from.x + static_cast<float>(i);
    const float share = std::clamp(person.speed_at(axis.time_at(x)) / top, 0.0F, 1.0F);
    draw.PathLineTo({x, graph.to.y - share * graph.height()});
  }
  draw.PathStroke(colour::accent, ImDrawFlags_None, theme.px(1.5F));
  draw_text(theme.small, {graph.from.x + theme.px(4), graph.from.y}, colour::dim,
            fixed(top, top < 10 ? 1 : 0) + " m/s");
}

// Left feet above, right feet below.
void draw_footfalls(const Theme& theme, const Area& place, const TimeAxis& axis, const TrackedPerson& person) {
  if (static_cast<float>(person.footfalls.size()) > 2 * place.width()) {
    return draw_text(theme.small, place.from, colour::faint, "Too many steps to draw each.");
  }
  const float half = place.height() / 2;
  const float letters = place.from.x - theme.px(letter_width);
  draw_text(theme.small, {letters, place.from.y - theme.px(1)}, colour::faint, "L");
  draw_text(theme.small, {letters, place.from.y + half - theme.px(1)}, colour::faint, "R");
  for (const Footfall& foot : person.footfalls) {
    const float x = std::floor(axis.x_of(foot.seconds)) + 0.5F, y = place.from.y + (foot.is_left ? 0 : half);
    ImGui::GetWindowDrawList()->AddLine({x, y + 1}, {x, y + half - 1}, foot.is_left ? colour::frame : colour::changed,
                                        theme.px(1));
  }
}

void show_speed_graph(Widgets& widgets, const Area& graph, const TimeAxis& axis, const FrameReport& report,
                      Requests& requests) {
  const TrackedPerson& person = *report.selected->tracked;
  const TrackClock& clock = report.tracks->clock;
  const auto go_to = [&](double seconds) {
    const TrackClock wanted = gone_to(clock, seconds);
    if (wanted != clock) requests.ask(Seek{wanted});
  };
  widgets.pressable("Selected.speed", graph);
  const double pointed = axis.time_at(ImGui::GetIO().MousePos.x);
  if (ImGui::IsItemActive()) {
    go_to(pointed);
  } else if (ImGui::IsItemHovered()) {
    show_lines({seconds_text(pointed) + ": " + fixed(person.speed_at(pointed), 2) + " m/s, " +
                    fixed(person.way_at(pointed), 1) + " m walked",
                "A mean of 0.8 s in the file. The steps are those", "that are shown: the file has none."});
  }
  if (const int step = widgets.stop("Selected.speed", graph).take_step()) {
    go_to(clock.seconds + step * report.tracks->people->row());
  }
}

}  // namespace

std::string state_of_tracked(const SelectionReport& selected, double seconds) {
  const TrackedPerson& person = *selected.tracked;
  if (seconds < person.presence.first) return "comes at " + seconds_text(person.presence.first);
  if (seconds > person.presence.last) return "left at " + seconds_text(person.presence.last);
  const bool is_slow = selected.role == Role::stand && person.speed_at(seconds) > slow_steps;
  return is_slow ? "slow walk" : role_names.at(index_of(selected.role));
}

void show_tracked_person(Widgets& widgets, const Area& place, const FrameReport& report, Requests& requests) {
  const Theme& theme = widgets.theme();
  const TrackedPerson& person = *report.selected->tracked;
  const double now = report.tracks->clock.seconds;
  draw_text(theme.small, place.from, colour::dim, where_words(*report.selected, now));
  draw_text(theme.small, {place.from.x, place.from.y + theme.px(line_height)}, colour::text, way_words(person, now));
  const float left = place.from.x + theme.px(letter_width), axis_top = place.to.y - theme.px(axis_height);
  const Area graph{.from = {left, place.from.y + theme.px(2 * line_height + 2)},
                   .to = {place.to.x, axis_top - theme.px(steps_height + 2)}};
  const Area steps{.from = {left, graph.to.y + theme.px(2)}, .to = {place.to.x, axis_top}};
  const TimeAxis axis{.from = left, .to = place.to.x, .first = person.presence.first, .last = person.presence.last};
  show_speed_graph(widgets, graph, axis, report, requests);
  draw_speeds(theme, graph, axis, person);
  draw_footfalls(theme, steps, axis, person);
  axis.draw_labels(theme, {.from = graph.from, .to = {place.to.x, axis_top}});
  if (!person.presence.has(now)) return;
  const float x = std::floor(axis.x_of(now)) + 0.5F;
  ImGui::GetWindowDrawList()->AddLine({x, graph.from.y}, {x, axis_top}, colour::text, theme.px(1.5F));
}

}  // namespace throng::app
