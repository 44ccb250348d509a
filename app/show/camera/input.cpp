#include "app/show/camera/input.h"

namespace throng::app {
namespace {

bool is_modifier(Key key) { return key == Key::shift || key == Key::control || key == Key::alt || key == Key::super; }

}  // namespace

const InputFrame& InputQueue::next_frame() {
  frame_.moved_x = frame_.moved_y = frame_.wheel = 0;
  frame_.pressed.clear();
  frame_.characters.clear();
  frame_.dropped.clear();
  changed_keys_.reset();
  changed_buttons_.reset();
  while (!events_.empty() && !must_wait(events_.front())) {
    apply(events_.front());
    events_.pop_front();
  }
  return frame_;
}

bool InputQueue::must_wait(const InputEvent& event) const {
  switch (event.kind) {
    case InputEvent::Kind::key:
      return changed_keys_[static_cast<std::size_t>(event.key)] || (is_modifier(event.key) && !frame_.pressed.empty());
    case InputEvent::Kind::button:
      return changed_buttons_[static_cast<std::size_t>(event.button)];
    // A click belongs to the place where it happened, so the pointer stays there until the frame has seen it.
    case InputEvent::Kind::pointer:
      return changed_buttons_.any();
    case InputEvent::Kind::focus_lost:
      return changed_keys_.any() || changed_buttons_.any();
    case InputEvent::Kind::wheel:
    case InputEvent::Kind::character:
    case InputEvent::Kind::file:
      return false;
  }
  return false;
}

void InputQueue::apply(const InputEvent& event) {
  switch (event.kind) {
    case InputEvent::Kind::pointer:
      move_pointer(event.x, event.y);
      break;
    case InputEvent::Kind::button:
      frame_.buttons_down[static_cast<std::size_t>(event.button)] = event.down;
      changed_buttons_.set(static_cast<std::size_t>(event.button));
      break;
    case InputEvent::Kind::wheel:
      frame_.wheel += event.wheel;
      break;
    case InputEvent::Kind::key:
      change_key(event.key, event.down);
      break;
    case InputEvent::Kind::character:
      frame_.characters.push_back(event.character);
      break;
    case InputEvent::Kind::file:
      frame_.dropped.push_back(event.path);
      break;
    case InputEvent::Kind::focus_lost:
      frame_.keys_down.reset();
      frame_.buttons_down.reset();
      break;
  }
}

void InputQueue::move_pointer(float x, float y) {
  const bool was_inside = frame_.pointer_x >= 0 && frame_.pointer_y >= 0;
  if (was_inside && x >= 0 && y >= 0) {
    frame_.moved_x += x - frame_.pointer_x;
    frame_.moved_y += y - frame_.pointer_y;
  }
  frame_.pointer_x = x;
  frame_.pointer_y = y;
}

void InputQueue::change_key(Key key, bool down) {
  const auto index = static_cast<std::size_t>(key);
  if (down && !frame_.keys_down[index]) {
    if (!is_modifier(key)) frame_.pressed.push_back(key);
    frame_.combined[index] = !is_modifier(key) && frame_.combines();
  }
  frame_.keys_down[index] = down;
  changed_keys_.set(index);
}

}  // namespace throng::app
