#include "app/overlay/replay_bar.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/overlay/cards.h"

namespace throng::app {
namespace {

namespace bar {
constexpr float height = 66, margin = 12, padding = 14, button = 32, control = 24, gap = 6;
constexpr float speed = 40, loop = 48, shortest_track = 80;
}  // namespace bar

std::string speed_words(float speed) {
  return speed < 1 ? fixed(speed, speed < 0.5F ? 2 : 1) + "x" : fixed(speed, 0) + "x";
}

/// The controls from left to right.
class Controls {
 public:
  Controls(Widgets& widgets, const Area& place) : widgets_(widgets), place_(place) {}

  /// Shows a control at the left or the right end of what is left. Returns whether it was clicked.
  bool left(const std::string& name, float width) { return show(name, take(width, true)); }
  bool right(const std::string& name, float width) { return show(name, take(width, false)); }
  /// The place of the last control.
  const Area& last() const { return last_; }
  const Area& rest() const { return place_; }
  bool has_room_for(float width) const { return place_.width() > widgets_.theme().px(width); }

  void fill(bool chosen) const {
    const bool hovered = ImGui::IsItemHovered();
    const ImU32 ground = chosen ? colour::accent : (hovered ? colour::well_hovered : colour::well);
    ImGui::GetWindowDrawList()->AddRectFilled(last_.from, last_.to, ground, widgets_.theme().px(4));
  }
  void write(const std::string& words, bool chosen) const {
    const float y = last_.from.y + (last_.height() - widgets_.theme().small->FontSize) / 2;
    draw_text(widgets_.theme().small, {(last_.from.x + last_.to.x) / 2, y}, chosen ? colour::on_accent : colour::text,
              words, 0.5F);
  }

 private:
  Area take(float plain_width, bool from_left) {
    const float width = widgets_.theme().px(plain_width), between = widgets_.theme().px(bar::gap);
    Area taken = place_;
    if (from_left) {
      taken.to.x = taken.from.x + width;
      place_.from.x = taken.to.x + between;
    } else {
      taken.from.x = taken.to.x - width;
      place_.to.x = taken.from.x - between;
    }
    return taken;
  }
  bool show(const std::string& name, const Area& place) {
    last_ = place;
    return widgets_.clickable(name, place);
  }

  Widgets& widgets_;
  Area place_, last_;
};

void draw_pause(const Theme& theme, ImVec2 middle) {
  for (const float side : {-3.5F, 3.5F}) {
    const float x = middle.x + theme.px(side), half = theme.px(1.75F), tall = theme.px(6);
    ImGui::GetWindowDrawList()->AddRectFilled({x - half, middle.y - tall}, {x + half, middle.y + tall}, colour::text);
  }
}

// A triangle that points to the right, or to the left where `way` is -1; with a bar before its tip where it steps.
void draw_arrow(const Theme& theme, ImVec2 middle, float way, bool steps) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float x = middle.x - way * theme.px(steps ? 2 : 0), half = theme.px(5), tall = theme.px(6);
  const ImVec2 tip(x + way * half, middle.y), top(x - way * half, middle.y - tall),
      foot(x - way * half, middle.y + tall);
  if (way > 0) {
    draw.AddTriangleFilled(top, tip, foot, colour::text);
  } else {
    draw.AddTriangleFilled(tip, top, foot, colour::text);
  }
  if (!steps) return;
  const float bar = middle.x + way * theme.px(6);
  draw.AddLine({bar, middle.y - tall}, {bar, middle.y + tall}, colour::text, theme.px(2));
}

void show_buttons(const Theme& theme, Controls& controls, const ReplayReport& replay, ReplayCommands& commands) {
  const auto middle = [&] {
    return ImVec2((controls.last().from.x + controls.last().to.x) / 2,
                  (controls.last().from.y + controls.last().to.y) / 2);
  };
  commands.change_pause |= controls.left("Replay.play", bar::button);
  controls.fill(false);
  if (replay.paused || replay.ended) {
    draw_arrow(theme, middle(), 1, false);
  } else {
    draw_pause(theme, middle());
  }
  for (const int way : {-1, 1}) {
    if (controls.left(way < 0 ? "Replay.back" : "Replay.on", bar::button)) commands.step = way;
    controls.fill(false);
    draw_arrow(theme, middle(), static_cast<float>(way), true);
  }
}

void show_speeds(Controls& controls, const ReplayReport& replay, ReplayCommands& commands) {
  const float needed = static_cast<float>(replay_speeds.size()) * (bar::speed + bar::gap) + bar::loop + bar::gap;
  if (!controls.has_room_for(needed + bar::shortest_track)) return;
  for (std::size_t i = replay_speeds.size(); i > 0; --i) {
    const float speed = replay_speeds.at(i - 1);
    if (controls.right("Replay.speed:" + speed_words(speed), bar::speed)) commands.speed = speed;
    controls.fill(speed == replay.speed);
    controls.write(speed_words(speed), speed == replay.speed);
  }
  commands.change_loop |= controls.right("Replay.loop", bar::loop);
  controls.fill(replay.loops);
  controls.write("Loop", replay.loops);
}

// A press anywhere on the track goes to the frame there, and a drag goes along.
void show_track(Widgets& widgets, const Area& place, const ReplayReport& replay, ReplayCommands& commands) {
  const Theme& theme = widgets.theme();
  widgets.pressable("Replay.track", place);
  const float from = place.from.x + theme.px(7), to = place.to.x - theme.px(7);
  const float frames = static_cast<float>(std::max<std::uint64_t>(replay.frames, 2) - 1);
  std::uint64_t shown = replay.sought.value_or(replay.frame);
  if (ImGui::IsItemActive()) {
    const float share = std::clamp((ImGui::GetIO().MousePos.x - from) / std::max(to - from, 1.0F), 0.0F, 1.0F);
    const auto wanted = 1 + static_cast<std::uint64_t>(std::lround(share * frames));
    if (wanted != shown) commands.go_to = wanted;
    shown = wanted;
  }
  if (const int step = widgets.stop("Replay.track", place).take_step()) {
    const auto last = static_cast<std::int64_t>(std::max<std::uint64_t>(replay.frames, 1));
    commands.go_to =
        static_cast<std::uint64_t>(std::clamp(static_cast<std::int64_t>(shown) + step, std::int64_t{1}, last));
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

void show_replay_bar(Widgets& widgets, const Area& crowd, const ReplayReport& replay, ReplayCommands& commands) {
  const Theme& theme = widgets.theme();
  const Area place{.from = {crowd.from.x + theme.px(bar::margin), crowd.to.y - theme.px(bar::margin + bar::height)},
                   .to = {crowd.to.x - theme.px(bar::margin), crowd.to.y - theme.px(bar::margin)}};
  begin_fixed_window("Replay", place, theme.px(10));
  widgets.record("Replay", place);
  widgets.cover(place);
  const float left = place.from.x + theme.px(bar::padding), right = place.to.x - theme.px(bar::padding);
  const float top = place.from.y + theme.px(9);
  const std::string count = "frame " + std::to_string(replay.frame) + " of " + std::to_string(replay.frames);
  draw_text(theme.small, {right, top}, colour::dim, count, 1);
  ImGui::PushClipRect({left, top}, {right - text_width(theme.small, count) - theme.px(bar::gap), top + theme.px(20)},
                      true);
  draw_text(theme.regular, {left, top - theme.px(1)}, replay.differs ? colour::changed : colour::text,
            state_of_replay(replay));
  ImGui::PopClipRect();
  const float below = place.to.y - theme.px(9);
  Controls controls(widgets, {.from = {left, below - theme.px(bar::control)}, .to = {right, below}});
  show_buttons(theme, controls, replay, commands);
  show_speeds(controls, replay, commands);
  show_track(widgets, controls.rest(), replay, commands);
  ImGui::End();
}

void apply_replay_keys(const InputFrame& input, ReplayCommands& commands) {
  for (const Key key : input.pressed) {
    commands.change_pause |= key == Key::space;
    if (key == Key::left) commands.step = -1;
    if (key == Key::right) commands.step = 1;
  }
}

}  // namespace throng::app
