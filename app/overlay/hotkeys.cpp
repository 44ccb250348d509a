#include "app/overlay/hotkeys.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace throng::app {

namespace {

// A list closes itself (Widgets::pick).
void close_the_topmost(const OpenThings& open, OverlaySwitches& switches, OverlayCommands& commands) {
  if (open.list) return;
  if (!switches.search.empty() && !switches.hidden && !open.viewer) {
    switches.search.clear();
  } else if (switches.help && !switches.hidden) {
    switches.help = false;
  } else if (switches.log && !switches.hidden) {
    switches.log = false;
  } else if (open.viewer) {
    commands.viewer.leave = true;
  } else if (open.selection) {
    commands.deselect = true;
  } else {
    commands.quit = true;
  }
}

constexpr std::size_t place_of_digit(Key key) {
  return static_cast<std::size_t>(key) - static_cast<std::size_t>(Key::digit_1);
}

void add_camera_key(const InputFrame& input, Key key, const OpenThings& open, CameraCommands& commands) {
  commands.home |= key == Key::home;
  const bool follows = key == Key::g && open.selection;
  (input.down(Key::shift) ? commands.follow_behind : commands.change_follow) |= follows;
  if (place_of_digit(key) >= bookmark_count) return;
  (input.down(Key::control) ? commands.keep_bookmark : commands.go_to_bookmark) = place_of_digit(key);
}

void ask_the_crowd(const InputFrame& input, Key key, const OpenThings& open, Tuning& tuning,
                   OverlayCommands& commands) {
  if (key == Key::space) tuning.paused = !tuning.paused;
  commands.frame_crowd |= key == Key::f && !input.down(Key::control);
  commands.copy_camera |= key == Key::c;
  commands.record |= key == Key::r;
  commands.push_over |= key == Key::p && open.selection;
}

void ask_the_viewer(Key key, const ViewerSettings& settings, ViewerCommands& commands) {
  commands.face_front |= key == Key::f;
  if (key != Key::space) return;
  commands.settings = settings;
  commands.settings->plays = !settings.plays;
}

bool types_slash(const InputFrame& input) { return input.characters.find(U'/') != std::u32string::npos; }

// Some keyboards have them above a digit, whose key then means nothing else.
bool types_sign(const InputFrame& input) { return input.characters.find_first_of(U"/[]") != std::u32string::npos; }

int tabs_further(const InputFrame& input, Key key) {
  if (!input.down(Key::control)) return 0;
  if (key == Key::tab) return input.down(Key::shift) ? -1 : 1;
  return (key == Key::page_down ? 1 : 0) - (key == Key::page_up ? 1 : 0);
}

void ask_for_search(const InputFrame& input, OverlaySwitches& switches) {
  const bool by_f = input.down(Key::control) && std::ranges::count(input.pressed, Key::f) > 0;
  if (!by_f && !types_slash(input)) return;
  switches.hidden = false;
  switches.enters_search = true;
}

}  // namespace

void apply_hotkeys(const InputFrame& input, const OpenThings& open, OverlaySwitches& switches, Tuning& tuning,
                   OverlayCommands& commands) {
  if (!open.viewer) ask_for_search(input, switches);
  commands.exact_crowd = input.down(Key::x) && !open.viewer;
  for (const Key key : input.pressed) {
    if (key == Key::tab && !input.down(Key::control)) switches.hidden = !switches.hidden;
    switches.tabs_further += tabs_further(input, key);
    if (key == Key::f1) switches.help = !switches.help;
    if (key == Key::l) switches.log = !switches.log;
    commands.reload_shaders |= key == Key::f5;
    commands.screenshot |= key == Key::f12;
    if (key == Key::escape) close_the_topmost(open, switches, commands);
    if (open.viewer) {
      ask_the_viewer(key, *open.viewer, commands.viewer);
    } else {
      ask_the_crowd(input, key, open, tuning, commands);
      if (!types_sign(input)) add_camera_key(input, key, open, commands.cameras);
    }
  }
}

void apply_history_keys(const InputFrame& input, TuningHistory& history, Tuning& tuning) {
  if (!input.down(Key::control)) return;
  for (const Key key : input.pressed) {
    const bool redoes = key == Key::y || (key == Key::z && input.down(Key::shift));
    if (redoes) {
      history.redo(tuning);
    } else if (key == Key::z) {
      history.undo(tuning);
    }
  }
}

void apply_pair_key(const InputFrame& input, TuningPair& pair, Tuning& tuning, OverlayCommands& commands) {
  if (std::ranges::count(input.pressed, Key::b) == 0) return;
  if (!pair.has_two()) {
    commands.hint = "There is nothing to compare with yet. Copy A to B in the tab Presets, then change some values.";
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
