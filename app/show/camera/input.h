#pragma once

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace throng::app {

enum class MouseButton : std::uint8_t { left, right, middle, count };

/// The keys that the demo and text fields use. All others reach the overlay as characters only.
enum class Key : std::uint8_t {
  tab,
  left,
  right,
  up,
  down,
  page_up,
  page_down,
  home,
  end,
  insert,
  del,
  backspace,
  space,
  enter,
  escape,
  keypad_enter,
  a,
  b,
  c,
  d,
  e,
  f,
  g,
  l,
  o,
  p,
  q,
  r,
  s,
  v,
  w,
  x,
  y,
  z,
  digit_1,  // the digits follow each other
  digit_2,
  digit_3,
  digit_4,
  digit_5,
  digit_6,
  digit_7,
  digit_8,
  digit_9,
  digit_0,
  plus,
  minus,
  f1,
  f5,
  f6,
  f11,
  f12,
  shift,
  control,
  alt,
  super,
  count
};

/// One event at the window. Events come in the order in which they happen.
struct InputEvent {
  enum class Kind : std::uint8_t { pointer, button, wheel, key, character, file, focus_lost };
  Kind kind = Kind::pointer;
  float x = 0, y = 0;                      ///< pointer: pixels from the top left
  MouseButton button = MouseButton::left;  ///< button
  Key key = Key::space;                    ///< key
  bool down = false;                       ///< button, key
  float wheel = 0;                         ///< wheel: steps, up is positive
  char32_t character = 0;                  ///< character: Unicode code point
  std::string path = {};                   ///< file: dropped on the window; files of one drop are pushed together
};

/// Mouse and keyboard in a frame.
struct InputFrame {
  float pointer_x = -1, pointer_y = -1;  ///< pixels from the top left; negative: not over the window
  float moved_x = 0, moved_y = 0;        ///< pixels since the frame before
  float wheel = 0;                       ///< steps since the frame before
  std::bitset<static_cast<std::size_t>(MouseButton::count)> buttons_down;
  std::bitset<static_cast<std::size_t>(Key::count)> keys_down;
  std::bitset<static_cast<std::size_t>(Key::count)> combined;  ///< keys that went down with Ctrl, Alt or Super held
  std::vector<Key> pressed;          ///< keys that went down in this frame, in order; never Ctrl, Alt, Shift or Super
  std::u32string characters;         ///< text typed in this frame
  std::vector<std::string> dropped;  ///< files dropped on the window in this frame

  [[nodiscard]] bool was_pressed(Key key) const { return std::ranges::count(pressed, key) > 0; }
  [[nodiscard]] bool down(Key key) const { return keys_down[static_cast<std::size_t>(key)]; }
  [[nodiscard]] bool down(MouseButton button) const { return buttons_down[static_cast<std::size_t>(button)]; }
  /// Returns whether Ctrl, Alt or Super is held, which make another meaning of the keys with them.
  [[nodiscard]] bool combines() const { return down(Key::control) || down(Key::alt) || down(Key::super); }
  /// Returns whether a key is held by itself: it is no part of a combination, nor the rest of one.
  [[nodiscard]] bool down_alone(Key key) const {
    return down(key) && !combines() && !combined[static_cast<std::size_t>(key)];
  }
};

/// The text clipboard of the window system; both functions may be empty.
struct Clipboard {
  std::function<std::string()> get;
  std::function<void(const std::string&)> set;
};

/// Turns events into frames so that no press shorter than a frame is lost. A key or button changes at most once in a
/// frame; a second change, and all events after it, wait for the next frame. Ctrl, Alt, Shift and Super change before
/// all other keys of a frame, so that a combination has the ones that were held at its key.
class InputQueue {
 public:
  void push(const InputEvent& event) { events_.push_back(event); }

  /// Returns the state after the events of this frame, and starts the next frame.
  const InputFrame& next_frame();

 private:
  bool must_wait(const InputEvent& event) const;
  void apply(const InputEvent& event);
  void move_pointer(float x, float y);
  void change_key(Key key, bool down);

  std::deque<InputEvent> events_;
  InputFrame frame_;
  std::bitset<static_cast<std::size_t>(Key::count)> changed_keys_;
  std::bitset<static_cast<std::size_t>(MouseButton::count)> changed_buttons_;
};

}  // namespace throng::app
