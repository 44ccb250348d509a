#include <algorithm>
#include <cmath>
#include <string>

#include "app/window/panel/cards.h"
#include "app/window/panel/controls/bar.h"

namespace throng::app {
namespace {

namespace bar {
constexpr float height = 66, padding = 14, speed = 40, loop = 48, shortest_track = 80;
}  // namespace bar

void show_buttons(BarControls& controls, const ReplayReport& replay, Requests& requests) {
  if (controls.left("Replay.play", BarControls::button)) requests.ask(ToggleReplayPause{});
  controls.fill(false);
  if (replay.paused || replay.ended) {
    controls.draw_arrow(1, false);
  } else {
    controls.draw_pause();
  }
  for (const int way : {-1, 1}) {
    if (controls.left(way < 0 ? "Replay.back" : "Replay.on", BarControls::button)) requests.ask(StepReplay{way});
    controls.fill(false);
    controls.draw_arrow(static_cast<float>(way), true);
  }
}

void show_speeds(BarControls& controls, const ReplayReport& replay, Requests& requests) {
  const float needed =
      static_cast<float>(replay_speeds.size()) * (bar::speed + BarControls::gap) + bar::loop + BarControls::gap;
  if (!controls.has_room_for(needed + bar::shortest_track)) return;
  for (std::size_t i = replay_speeds.size(); i > 0; --i) {
    const float speed = replay_speeds.at(i - 1);
    if (controls.right("Replay.speed:" + times_words(speed), bar::speed)) requests.ask(SetReplaySpeed{speed});
    controls.fill(speed == replay.speed);
    controls.write(times_words(speed), speed == replay.speed);
  }
  if (controls.right("Replay.loop", bar::loop)) requests.ask(ToggleReplayLoop{});
  controls.fill(replay.loops);
  controls.write("Loop", replay.loops);
}

// A press anywhere on the track goes to the frame there, and a drag goes along.
void show_track(Widgets& widgets, const Area& place, const ReplayReport& replay, Requests& requests) {
  const Theme& theme = widgets.theme();
  widgets.pressable("Replay.track", place);
  const float from = place.from.x + theme.px(7), to = place.to.x - theme.px(7);
  const float frames = static_cast<float>(std::max<std::uint64_t>(replay.frames, 2) - 1);
  std::uint64_t shown = replay.sought.value_or(replay.frame);
  if (ImGui::IsItemActive()) {
    const float share = std::clamp((ImGui::GetIO().MousePos.x - from) / std::max(to - from, 1.0F), 0.0F, 1.0F);
    const auto wanted = 1 + static_cast<std::uint64_t>(std::lround(share * frames));
    if (wanted != shown) requests.ask(SeekReplay{wanted});
    shown = wanted;
  }
  if (const int step = widgets.stop("Replay.track", place).take_step()) {
    const auto last = static_cast<std::int64_t>(std::max<std::uint64_t>(replay.frames, 1));
    requests.ask(SeekReplay{
        static_cast<std::uint64_t>(std::clamp(static_cast<std::int64_t>(shown) + step, std::int64_t{1}, last))});
  }
  const auto x_of = [&](std::uint64_t frame) {
    return std::lerp(from, to, static_cast<float>(std::max<std::uint64_t>(frame, 1) - 1) / frames);
  };
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float y = std::floor((place.from.y + place.to.y) / 2), half = theme.px(2);
  draw.AddRectFilled({from, y - half}, {to, y + half}, colour::well_hovered, half);
  draw.AddRectFilled({from, y - half}, {x_of(replay.frame), y + half},
                     replay.differs ? colour::changed : colour::accent, half);
  const bool lively = ImGui::IsItemActive() || ImGui::IsItemHovered();
  draw.AddCircleFilled({x_of(shown), y}, theme.px(lively ? 7 : 6), lively ? colour::text : colour::accent);
}

std::string state_of_replay(const ReplayReport& replay) {
  if (replay.sought) return "On the way to frame " + std::to_string(*replay.sought);
  if (replay.ended) return replay.outcome;
  return replay.paused ? "Replay, paused" : "Replay";
}

}  // namespace

void show_replay_bar(Widgets& widgets, const Area& crowd, const ReplayReport& replay, Requests& requests) {
  const Theme& theme = widgets.theme();
  const Area place = begin_bar(widgets, "Replay", crowd, bar::height);
  const float left = place.from.x + theme.px(bar::padding), right = place.to.x - theme.px(bar::padding);
  const float top = place.from.y + theme.px(9);
  const std::string count = "frame " + with_thousands(replay.frame) + " of " + with_thousands(replay.frames);
  draw_text(theme.small, {right, top}, colour::dim, count, 1);
  ImGui::PushClipRect({left, top},
                      {right - text_width(theme.small, count) - theme.px(BarControls::gap), top + theme.px(20)}, true);
  draw_text(theme.regular, {left, top - theme.px(1)}, replay.differs ? colour::changed : colour::text,
            state_of_replay(replay));
  ImGui::PopClipRect();
  const float below = place.to.y - theme.px(9);
  BarControls controls(widgets, {.from = {left, below - theme.px(BarControls::height)}, .to = {right, below}});
  show_buttons(controls, replay, requests);
  show_speeds(controls, replay, requests);
  show_track(widgets, controls.rest(), replay, requests);
  ImGui::End();
}

void apply_replay_keys(const InputFrame& input, Requests& requests) {
  for (const Key key : input.pressed) {
    if (key == Key::space) requests.ask(ToggleReplayPause{});
    if (key == Key::left) requests.ask(StepReplay{-1});
    if (key == Key::right) requests.ask(StepReplay{1});
  }
}

}  // namespace throng::app
