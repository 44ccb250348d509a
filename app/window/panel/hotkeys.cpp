#include "app/window/panel/hotkeys.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace throng::app {

namespace {

// A list closes itself (Widgets::pick).
void close_the_topmost(const OpenThings& open, OverlaySwitches& switches, Requests& requests) {
  if (open.list) return;
  if (!switches.search.empty() && !switches.hidden && !open.viewer) {
    switches.search.clear();
  } else if (switches.help && !switches.hidden) {
    switches.help = false;
  } else if (switches.log && !switches.hidden) {
    switches.log = false;
  } else if (open.viewer) {
    requests.ask(LeaveViewer{});
  } else if (open.selected) {
    requests.ask(Select{});
  } else {
    requests.ask(Quit{});
  }
}

constexpr std::size_t place_of_digit(Key key) {
  return static_cast<std::size_t>(key) - static_cast<std::size_t>(Key::digit_1);
}

void add_camera_key(const InputFrame& input, Key key, const OpenThings& open, Requests& requests) {
  if (key == Key::home) requests.ask(GoHome{});
  if (key == Key::g && open.selected) {
    requests.ask(input.down(Key::shift) ? CameraRequest(FollowBehind{}) : CameraRequest(ToggleFollow{}));
  }
  if (const std::size_t place = place_of_digit(key); place < bookmark_count) requests.ask(GoToBookmark{place});
}

void ask_the_crowd(Key key, const OpenThings& open, Tuning& tuning, Requests& requests) {
  if (key == Key::space) tuning.paused = !tuning.paused;
  if (key == Key::f) requests.ask(FrameCrowd{});
  if (key == Key::c) requests.ask(CopyCamera{});
  if (key == Key::r) requests.ask(ToggleRecording{});
  if (key == Key::v) requests.ask(MakeVideo{});
  if (key == Key::p && open.selected) requests.ask(Push{*open.selected, open.ahead});
}

void ask_the_viewer(Key key, ViewerSettings settings, Requests& requests) {
  if (key == Key::f) requests.ask(FaceFront{});
  if (key != Key::space) return;
  settings.plays = !settings.plays;
  requests.ask(SetViewer{settings});
}

// Some keyboards have them above a digit, whose key then means nothing else.
bool types_sign(const InputFrame& input) { return input.characters.find_first_of(U"/[]") != std::u32string::npos; }

// The words for a key that does nothing now; empty: it does something, or is none of ours.
std::string why_nothing_happens(const InputFrame& input, Key key, const OpenThings& open) {
  if (!open.selected && key == Key::p) return "P pushes the selected character over. Click at one first.";
  if (!open.selected && key == Key::g) return "G follows the selected character. Click at one first.";
  if (!open.has_moments && (key == Key::left || key == Key::right)) {
    return "Left and Right go through a replay or a recorded crowd. W A S D fly.";
  }
  if (key == Key::up || key == Key::down) return "Up and Down go through the panel once F6 is pressed. W A S D fly.";
  const std::size_t place = place_of_digit(key);
  const bool goes_there = place < bookmark_count && !types_sign(input);
  if (!goes_there || open.kept.at(place)) return {};
  const std::string digit = std::to_string(place + 1);
  return "No place of the camera is kept under " + digit + ". Ctrl+" + digit + " keeps the present one.";
}

// The viewer has few keys, and a person may look for one of the crowd there.
bool is_for_the_crowd(Key key) {
  return key == Key::p || key == Key::g || key == Key::b || key == Key::c || key == Key::r || key == Key::v ||
         key == Key::x || key == Key::home || place_of_digit(key) < bookmark_count;
}

bool types_slash(const InputFrame& input) { return input.characters.find(U'/') != std::u32string::npos; }

void ask_for_search(OverlaySwitches& switches) {
  switches.hidden = false;
  switches.enters_search = true;
}

// What Ctrl and a key ask of the crowd.
void ask_the_crowd_by_control(bool shift, Key key, OverlaySwitches& switches, Requests& requests) {
  if (key == Key::f) ask_for_search(switches);
  if (key == Key::z) requests.ask(shift ? WindowRequest(Redo{}) : WindowRequest(Undo{}));
  if (key == Key::y) requests.ask(Redo{});
  if (const std::size_t place = place_of_digit(key); place < bookmark_count) requests.ask(KeepBookmark{place});
}

// What Ctrl and a key ask of the window, also while a person types.
void ask_the_window_by_control(bool shift, Key key, OverlaySwitches& switches, Requests& requests) {
  if (key == Key::q) requests.ask(Quit{});
  if (key == Key::o) switches.opens_file = true;
  if (key == Key::s) (shift ? switches.saves_anew : switches.saves) = true;
  if (key == Key::digit_0) switches.steps_larger = 0;
  constexpr int most_steps = 15;
  const int further = (key == Key::plus ? 1 : 0) - (key == Key::minus ? 1 : 0);
  switches.steps_larger = std::clamp(switches.steps_larger + further, -most_steps, most_steps);
}

int tabs_further(bool shift, Key key) {
  if (key == Key::tab) return shift ? -1 : 1;
  return (key == Key::page_down ? 1 : 0) - (key == Key::page_up ? 1 : 0);
}

}  // namespace

void apply_combinations(const InputFrame& input, const OpenThings& open, OverlaySwitches& switches,
                        Requests& requests) {
  const bool shift = input.down(Key::shift);
  const bool by_control = input.down(Key::control) && !input.down(Key::alt) && !input.down(Key::super);
  for (const Key key : input.pressed) {
    const bool by_alt = key == Key::enter && input.down(Key::alt) && !input.down(Key::control);
    if (key == Key::f11 || by_alt) requests.ask(ToggleFullScreen{});
    if (!by_control) continue;
    ask_the_window_by_control(shift, key, switches, requests);
    if (open.typing) continue;
    switches.tabs_further += tabs_further(shift, key);
    if (!open.viewer) ask_the_crowd_by_control(shift, key, switches, requests);
  }
}

void apply_hotkeys(const InputFrame& input, const OpenThings& open, OverlaySwitches& switches, Tuning& tuning,
                   Requests& requests) {
  if (!open.viewer && types_slash(input)) ask_for_search(switches);
  if (input.down_alone(Key::x) && !open.viewer) requests.ask(ShowExactCrowd{});
  for (const Key key : input.pressed) {
    if (key == Key::tab) switches.hidden = !switches.hidden;
    if (key == Key::f1) switches.help = !switches.help;
    if (key == Key::l) switches.log = !switches.log;
    if (key == Key::f5) requests.ask(ReloadShaders{});
    if (key == Key::f12) requests.ask(input.down(Key::shift) ? FrameRequest(TakeStill{}) : TakeScreenshot{});
    if (key == Key::escape) close_the_topmost(open, switches, requests);
    if (open.viewer) {
      ask_the_viewer(key, *open.viewer, requests);
      if (is_for_the_crowd(key)) requests.ask(Tell{"That key is about the crowd. Esc leaves the viewer."});
    } else {
      if (std::string why = why_nothing_happens(input, key, open); !why.empty()) requests.ask(Tell{std::move(why)});
      ask_the_crowd(key, open, tuning, requests);
      if (!types_sign(input)) add_camera_key(input, key, open, requests);
    }
  }
}

void apply_pair_key(const InputFrame& input, TuningPair& pair, Tuning& tuning, Requests& requests) {
  if (!input.was_pressed(Key::b)) return;
  if (!pair.has_two()) {
    requests.ask(
        Tell{"There is nothing to compare with yet. Copy A to B in the tab Presets, then change some values."});
  }
  pair.change_places(tuning);
}

std::optional<PicturePoint> CrowdClick::update(const InputFrame& input, bool pointer_free) {
  constexpr float most_movement = 4.0F;  // pixels that a hand moves while it clicks
  const bool down = input.down(MouseButton::left), was_down = std::exchange(was_down_, down);
  if (down && !was_down && pointer_free && !input.down(Key::alt))
    pressed_at_ = PicturePoint{input.pointer_x, input.pointer_y};
  if (!pressed_at_) return std::nullopt;
  const float moved = std::hypot(input.pointer_x - pressed_at_->x, input.pointer_y - pressed_at_->y);
  if (moved > most_movement) pressed_at_.reset();
  return down ? std::nullopt : std::exchange(pressed_at_, std::nullopt);
}

}  // namespace throng::app
