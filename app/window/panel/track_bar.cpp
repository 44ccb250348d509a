#include <algorithm>
#include <cmath>
#include <string>

#include "app/window/panel/cards.h"
#include "app/window/panel/controls/bar.h"
#include "app/window/panel/controls/plots.h"
#include "app/window/panel/controls/time_axis.h"
#include "app/window/panel/tabs.h"

namespace throng::app {
namespace {

namespace track {
constexpr float padding = 14, top = 7, handles = 12, graph = 36, labels = 16, gap = 4, bottom = 8;
constexpr float height = top + handles + graph + labels + gap + BarControls::height + bottom;
constexpr float handle = 11, sign = 24, rate = 48, loop = 48, whole = 52, video = 84, shortest_words = 60;
}  // namespace track

/// The bar, from top to bottom.
struct TrackLayout {
  Area handles, graph, controls;
};

TrackLayout lay_out_bar(const Theme& theme, const Area& place) {
  const float left = place.from.x + theme.px(track::padding), right = place.to.x - theme.px(track::padding);
  const float inset = theme.px(track::handle), y = place.from.y + theme.px(track::top);
  const float graph = y + theme.px(track::handles), below = place.to.y - theme.px(track::bottom);
  return {.handles = {.from = {left + inset, y}, .to = {right - inset, graph}},
          .graph = {.from = {left + inset, graph}, .to = {right - inset, graph + theme.px(track::graph)}},
          .controls = {.from = {left, below - theme.px(BarControls::height)}, .to = {right, below}}};
}

/// Holds the clock that a person sees and changes: as it was reported, or as it was asked for in this frame.
class ClockInHand {
 public:
  explicit ClockInHand(const TabContext& context) : context_(context) {}

  const TrackClock& now() const {
    const Seek* const asked = last_of<Seek>(context_.requests);
    return asked != nullptr ? asked->clock : context_.report.tracks->clock;
  }
  const PeopleOverTime& people() const { return *context_.report.tracks->people; }
  void set(const TrackClock& clock) {
    if (clock != now()) context_.requests.ask(Seek{clock});
  }
  bool plays() const { return !context_.tuning.paused && !has_ended(now()); }
  bool goes_back() const { return now().rate < 0.0; }
  void play(bool backwards) {
    set(playing(now(), backwards));
    context_.tuning.paused = false;
  }
  /// Goes some rows on, or back.
  void step(int rows) {
    set(gone_to(now(), row_from(now().seconds, people().first(), people().row(), rows)));
    context_.tuning.paused = true;
  }

 private:
  const TabContext& context_;
};

std::string count_of(std::size_t people) {
  if (people == 0) return "nobody";
  return counted_people(people);
}

std::string state_words(const ClockInHand& clock, bool with_the_whole) {
  const PeopleOverTime& people = clock.people();
  const std::string from = people.first() == 0.0 ? "" : fixed(people.first(), 2) + " to ";
  const std::string of = with_the_whole ? " of " + from + seconds_text(people.last()) : "";
  return seconds_text(clock.now().seconds) + of + ", " + count_of(people.at(clock.now().seconds));
}

bool is_whole(const ClockInHand& clock) {
  return clock.now().first <= clock.people().first() && clock.now().last >= clock.people().last();
}

// The fullest time that a column of pixels shows decides how high it is.
void draw_people(const Theme& theme, const Area& graph, const TimeAxis& axis, const ClockInHand& clock) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw_well(theme, {.from = {graph.from.x, graph.from.y}, .to = graph.to});
  const auto counts = clock.people().most_by_column();
  const auto highest = static_cast<float>(std::max<std::size_t>(clock.people().most(), 1));
  const auto pixels = static_cast<std::size_t>(std::max(graph.width(), 1.0F));
  const float from = axis.x_of(clock.now().first), to = axis.x_of(clock.now().last);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    const std::size_t first = pixel * counts.size() / pixels;
    const std::size_t last = std::max((pixel + 1) * counts.size() / pixels, first + 1);
    const std::uint32_t most = *std::max_element(counts.begin() + static_cast<std::ptrdiff_t>(first),
                                                 counts.begin() + static_cast<std::ptrdiff_t>(last));
    if (most == 0) continue;
    const float x = graph.from.x + static_cast<float>(pixel);
    const float y = graph.to.y - (graph.height() - theme.px(3)) * static_cast<float>(most) / highest;
    const bool is_played = x + 1 >= from && x <= to;
    draw.AddRectFilled({x, y}, {x + 1, graph.to.y},
                       is_played ? colour::with_alpha(colour::frame, 0.55F) : colour::with_alpha(colour::dim, 0.3F));
  }
  const std::string most = "at most " + with_thousands(clock.people().most());
  const ImVec2 at(graph.from.x + theme.px(4), graph.from.y + theme.px(2));
  draw.AddRectFilled({at.x - theme.px(2), at.y},
                     {at.x + text_width(theme.small, most) + theme.px(3), at.y + theme.px(15)},
                     colour::with_alpha(colour::panel, 0.6F), theme.px(3));
  draw_text(theme.small, at, colour::text, most);
}

// The handle of an end lies beside it, outside of the part, so that both can be grasped however near they are.
void show_end(Widgets& widgets, const Area& handles, const TimeAxis& axis, bool is_last, ClockInHand& clock) {
  const Theme& theme = widgets.theme();
  const std::string name = is_last ? "Tracks.to" : "Tracks.from";
  const float width = theme.px(track::handle), out = is_last ? width : -width;
  const auto end = [&] { return is_last ? clock.now().last : clock.now().first; };
  const auto place_at = [&](float x) {
    return Area{.from = {std::min(x, x + out), handles.from.y}, .to = {std::max(x, x + out), handles.to.y}};
  };
  const Area place = place_at(axis.x_of(end()));
  widgets.pressable(name, place);
  const bool lively = ImGui::IsItemActive() || ImGui::IsItemHovered();
  const auto move = [&](double seconds) {
    const double at = std::clamp(seconds, clock.people().first(), clock.people().last());
    const double other = is_last ? std::min(clock.now().first, at) : std::max(clock.now().last, at);
    clock.set(is_last ? with_part(clock.now(), other, at) : with_part(clock.now(), at, other));
  };
  if (ImGui::IsItemActive()) {
    move(axis.time_at(ImGui::GetIO().MousePos.x - out / 2));
  } else if (ImGui::IsItemHovered()) {
    show_lines({(is_last ? "The part ends at " : "The part begins at ") + seconds_text(end()),
                std::string("Drag it. The key ") + (is_last ? "]" : "[") + " puts it at the present time."});
  }
  if (const int step = widgets.stop(name, place).take_step()) move(end() + step * clock.people().row());
  const Area drawn = place_at(axis.x_of(end()));
  const float x = is_last ? drawn.from.x : drawn.to.x;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 ink = lively ? colour::text : (is_whole(clock) ? colour::dim : colour::changed);
  draw.AddTriangleFilled({x, drawn.from.y + theme.px(1)}, {x, drawn.to.y}, {x + out, drawn.from.y + theme.px(1)}, ink);
  if (!is_whole(clock)) draw.AddLine({x, drawn.to.y}, {x, drawn.to.y + theme.px(track::graph)}, ink, theme.px(1));
}

void show_graph(Widgets& widgets, const Area& graph, const TimeAxis& axis, ClockInHand& clock) {
  const Theme& theme = widgets.theme();
  widgets.pressable("Tracks.track", graph);
  const float pointer = ImGui::GetIO().MousePos.x;
  if (ImGui::IsItemActive()) {
    clock.set(gone_to(clock.now(), axis.time_at(pointer)));
  } else if (ImGui::IsItemHovered()) {
    const double seconds = axis.time_at(pointer);
    const bool is_in_part = seconds >= clock.now().first && seconds <= clock.now().last;
    show_lines({seconds_text(seconds) + ", " + count_of(clock.people().at(seconds)),
                is_in_part ? "" : "Outside of the part that is played."});
  }
  const bool lively = ImGui::IsItemActive() || ImGui::IsItemHovered();
  if (const int step = widgets.stop("Tracks.track", graph).take_step()) clock.step(step);
  draw_people(theme, graph, axis, clock);
  axis.draw_labels(theme, graph);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float x = std::floor(axis.x_of(clock.now().seconds)) + 0.5F;
  draw.AddLine({x, graph.from.y - theme.px(4)}, {x, graph.to.y}, colour::text, theme.px(lively ? 2 : 1.5F));
  draw.AddCircleFilled({x, graph.from.y - theme.px(5)}, theme.px(lively ? 6 : 5),
                       lively ? colour::text : colour::accent);
}

void show_players(BarControls& controls, ClockInHand& clock, Tuning& tuning) {
  const auto show_step = [&](const char* name, int way) {
    if (controls.left(name, BarControls::button)) clock.step(way);
    controls.fill(false);
    controls.draw_arrow(static_cast<float>(way), true);
  };
  const auto show_play = [&](const char* name, bool backwards) {
    const bool plays = clock.plays() && clock.goes_back() == backwards;
    if (controls.left(name, BarControls::button)) {
      if (plays) {
        tuning.paused = true;
      } else {
        clock.play(backwards);
      }
    }
    controls.fill(false);
    if (plays) {
      controls.draw_pause();
    } else {
      controls.draw_arrow(backwards ? -1.0F : 1.0F, false);
    }
  };
  show_step("Tracks.back", -1);
  show_play("Tracks.backwards", true);
  show_play("Tracks.play", false);
  show_step("Tracks.on", 1);
}

double next_rate(double rate, bool faster) {
  constexpr double nearly = 1e-9;
  if (faster) {
    const auto* const next = std::ranges::upper_bound(track_rates, rate + nearly);
    return next == track_rates.end() ? std::max(rate, track_rates.back()) : *next;
  }
  const auto* const here = std::ranges::lower_bound(track_rates, rate - nearly);
  return here == track_rates.begin() ? std::min(rate, track_rates.front()) : *(here - 1);
}

void show_choices(BarControls& controls, ClockInHand& clock) {
  const auto set_rate = [&](double rate) {
    TrackClock changed = clock.now();
    changed.rate = std::copysign(rate, changed.rate);
    clock.set(changed);
  };
  const double rate = std::abs(clock.now().rate);
  if (controls.right("Tracks.whole", track::whole)) {
    clock.set(with_part(clock.now(), clock.people().first(), clock.people().last()));
  }
  if (ImGui::IsItemHovered()) show_lines({"Plays the whole file again."});
  controls.fill(false);
  controls.write("Whole", false);
  if (controls.right("Tracks.loop", track::loop)) {
    TrackClock changed = clock.now();
    changed.repeats = !changed.repeats;
    clock.set(changed);
  }
  if (ImGui::IsItemHovered()) show_lines({"At its end the part begins anew, or else it stays there."});
  controls.fill(clock.now().repeats);
  controls.write("Loop", clock.now().repeats);
  for (const bool faster : {true, false}) {
    if (!faster) {
      if (controls.right("Tracks.rate", track::rate)) set_rate(1.0);
      if (ImGui::IsItemHovered()) {
        show_lines({"Seconds of the file in a second; a click makes it 1.",
                    "The value Speed in the tab Crowd multiplies it."});
      }
      controls.fill(false);
      controls.write(times_words(static_cast<float>(clock.now().rate)), false);
    }
    if (controls.right(faster ? "Tracks.faster" : "Tracks.slower", track::sign)) set_rate(next_rate(rate, faster));
    controls.fill(false);
    controls.write(faster ? "+" : "-", false);
  }
}

void show_video(BarControls& controls, Requests& requests) {
  if (controls.right("Tracks.video", track::video)) requests.ask(MakeVideo{});
  if (ImGui::IsItemHovered()) {
    show_lines({"Makes a video of the part in full quality while the window goes on,",
                "seen by the camera as it is now. Needs ffmpeg. Key V."});
  }
  controls.fill(false);
  controls.write("Make video", false);
}

void write_state(const Theme& theme, const Area& place, const ClockInHand& clock) {
  const float y = place.from.y + (place.height() - font_height(theme.regular)) / 2;
  std::string words = state_words(clock, true);
  if (text_width(theme.regular, words) > place.width() - theme.px(12)) words = state_words(clock, false);
  ImGui::PushClipRect(place.from, place.to, true);
  draw_text(theme.regular, {place.from.x + theme.px(6), y}, colour::text, words);
  const float used = text_width(theme.regular, words) + theme.px(24);
  const std::string part = "part " + fixed(clock.now().first, 2) + " to " + fixed(clock.now().last, 2) + " s";
  if (!is_whole(clock) && place.width() > used + text_width(theme.small, part)) {
    draw_text(theme.small, {place.from.x + used, y + theme.px(1)}, colour::changed, part);
  }
  ImGui::PopClipRect();
}

}  // namespace

float height_of_track_bar(const Theme& theme) { return theme.px(bar_margin + track::height); }

void show_track_bar(const TabContext& context, const Area& crowd) {
  Widgets& widgets = context.widgets;
  const Theme& theme = widgets.theme();
  ClockInHand clock(context);
  const Area place = begin_bar(widgets, "Tracks", crowd, track::height);
  const TrackLayout layout = lay_out_bar(theme, place);
  const TimeAxis axis{.from = layout.graph.from.x,
                      .to = layout.graph.to.x,
                      .first = clock.people().first(),
                      .last = clock.people().last()};
  show_graph(widgets, layout.graph, axis, clock);
  show_end(widgets, layout.handles, axis, false, clock);
  show_end(widgets, layout.handles, axis, true, clock);
  BarControls controls(widgets, layout.controls);
  show_players(controls, clock, context.tuning);
  constexpr float choices = track::whole + track::loop + track::rate + 2 * track::sign + 5 * BarControls::gap;
  constexpr float with_video = choices + track::video + BarControls::gap;
  if (controls.has_room_for(with_video + track::shortest_words)) show_video(controls, context.requests);
  if (controls.has_room_for(choices + track::shortest_words)) show_choices(controls, clock);
  write_state(theme, controls.rest(), clock);
  ImGui::End();
}

void apply_track_keys(const InputFrame& input, const TracksReport& tracks, Tuning& tuning, Requests& requests) {
  TrackClock clock = tracks.clock;
  const PeopleOverTime& people = *tracks.people;
  for (const Key key : input.pressed) {
    const bool shift = input.down(Key::shift);
    if (key == Key::left || key == Key::right) {
      const int way = key == Key::left ? -1 : 1;
      const double wanted = shift ? clock.seconds + way : row_from(clock.seconds, people.first(), people.row(), way);
      clock = gone_to(clock, wanted);
      tuning.paused = true;
    }
    if (key == Key::space && (shift || has_ended(clock))) {
      clock = playing(clock, shift ? clock.rate > 0.0 : clock.rate < 0.0);
      tuning.paused = false;
    }
  }
  for (const char32_t sign : input.characters) {
    if (sign == U'[') clock = with_part(clock, clock.seconds, clock.last);
    if (sign == U']') clock = with_part(clock, clock.first, clock.seconds);
  }
  if (clock != tracks.clock) requests.ask(Seek{clock});
}

}  // namespace throng::app
