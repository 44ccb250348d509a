#include "app/window/panel/controls/panel_focus.h"

#include <algorithm>
#include <array>
#include <utility>

#include <imgui_internal.h>

namespace throng::app {
namespace {

constexpr int big_step = 10, frames_that_scroll = 4;  // a list within a tab comes into view after the tab scrolled
constexpr double seconds_until_it_rests = 0.5;

constexpr std::array panel_keys = {Key::up,    Key::down,  Key::left,         Key::right, Key::home,      Key::end,
                                   Key::space, Key::enter, Key::keypad_enter, Key::del,   Key::backspace, Key::tab};
constexpr std::array repeated_keys = std::to_array<std::pair<Key, ImGuiKey>>({{Key::up, ImGuiKey_UpArrow},
                                                                              {Key::down, ImGuiKey_DownArrow},
                                                                              {Key::left, ImGuiKey_LeftArrow},
                                                                              {Key::right, ImGuiKey_RightArrow}});

bool belongs_to_panel(const InputFrame& input, Key key) {
  return !input.combines() && std::ranges::count(panel_keys, key) > 0;
}

bool is_held_long(const InputFrame& input, Key key, ImGuiKey theirs) {
  return input.down(key) && !input.was_pressed(key) && ImGui::IsKeyPressed(theirs, true);
}

bool is_clicked(ImVec2 from, ImVec2 to) {
  return ImGui::IsMouseClicked(ImGuiMouseButton_Left) && ImGui::IsMouseHoveringRect(from, to) &&
         ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
}

bool is_disabled() { return (ImGui::GetCurrentContext()->CurrentItemFlags & ImGuiItemFlags_Disabled) != 0; }

}  // namespace

void PanelFocus::go_to_first_row() {
  ImGui::ClearActiveID();
  has_keys_ = true;
  go_to(0);
}

void PanelFocus::go_to(ImGuiID stop) {
  focused_ = stop;
  frames_to_scroll_ = frames_that_scroll;
  moved_at_ = ImGui::GetTime();
}

bool PanelFocus::rests() const { return has_keys_ && ImGui::GetTime() - moved_at_ > seconds_until_it_rests; }

void PanelFocus::begin_frame(InputFrame& input, const Before& before) {
  wish_ = {};
  is_last_ = is_stepping_ = false;
  name_.clear();
  stops_before_.swap(stops_);
  stops_.clear();
  const bool at_crowd = ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::GetIO().WantCaptureMouse;
  if (at_crowd) give_back();
  // The keys with which one leaves a field for the next widget, as in a table.
  constexpr std::array leaving = {Key::tab, Key::up, Key::down};
  const bool leaves = input.was_pressed(Key::f6) ||
                      (has_keys_ && std::ranges::any_of(leaving, [&](Key key) { return input.was_pressed(key); }));
  if (before.typing && leaves) ImGui::ClearActiveID();
  if (before.typing && !leaves) return;
  take_or_give_back(input, before);
  if (!has_keys_ || before.list) return;
  take_pressed(input);
  use_waiting_keys();
  is_stepping_ = input.down(Key::left) || input.down(Key::right);
}

void PanelFocus::take_or_give_back(InputFrame& input, const Before& before) {
  if (input.was_pressed(Key::f6)) {
    has_keys_ = !has_keys_;
    go_to(focused_);
    waiting_.clear();
  }
  const bool by_escape = has_keys_ && !before.list && !before.search && input.was_pressed(Key::escape);
  if (!by_escape) return;
  has_keys_ = false;
  std::erase(input.pressed, Key::escape);
}

void PanelFocus::take_pressed(InputFrame& input) {
  const bool shift = input.down(Key::shift);
  for (const Key key : input.pressed) {
    if (belongs_to_panel(input, key)) waiting_.push_back({key, shift});
  }
  for (const auto& [key, theirs] : repeated_keys) {
    if (belongs_to_panel(input, key) && is_held_long(input, key, theirs)) waiting_.push_back({key, shift});
  }
  std::erase_if(input.pressed, [&](Key key) { return belongs_to_panel(input, key); });
}

void PanelFocus::use_waiting_keys() {
  while (!waiting_.empty()) {
    const WaitingKey key = waiting_.front();
    waiting_.pop_front();
    if (use(key)) return;
  }
}

// Returns whether the widget has to see it before keys after it count.
bool PanelFocus::use(const WaitingKey& waiting) {
  switch (waiting.key) {
    case Key::up:
      move(-1);
      return false;
    case Key::down:
      move(1);
      return false;
    case Key::tab:
      move(waiting.shift ? -1 : 1);
      return false;
    case Key::home:
      if (!stops_before_.empty()) go_to(stops_before_.front().first);
      return false;
    case Key::end:
      if (!stops_before_.empty()) go_to(stops_before_.back().first);
      return false;
    case Key::left:
      wish_.step = waiting.shift ? -big_step : -1;
      return true;
    case Key::right:
      wish_.step = waiting.shift ? big_step : 1;
      return true;
    case Key::del:
    case Key::backspace:
      wish_.reset = true;
      return true;
    default:
      wish_.activate = true;
      return true;
  }
}

// After the last one comes the first.
void PanelFocus::move(int stops) {
  const auto count = static_cast<int>(stops_before_.size());
  if (count == 0) return;
  const auto found = std::ranges::find(stops_before_, focused_, &std::pair<ImGuiID, Stop>::first);
  const auto place = static_cast<int>(found - stops_before_.begin());
  const int next = found == stops_before_.end() ? 0 : (place + stops + count) % count;
  go_to(stops_before_[static_cast<std::size_t>(next)].first);
}

void PanelFocus::add(ImGuiID id, const std::string& name, ImVec2 from, ImVec2 to, Stop kind) {
  stops_.emplace_back(id, kind);
  if (is_clicked(from, to)) go_to(id);
  if (kind == Stop::row && std::exchange(wants_next_row_, false)) go_to(id);
  is_last_ = id == focused_;
  if (!is_last_) return;
  takes_keys_ = !is_disabled();
  if (!takes_keys_ && kind == Stop::row) wish_ = {};
  name_ = name;
  place_ = stops_.size() - 1;
  ImGuiWindow* const window = ImGui::GetCurrentWindow();
  if (frames_to_scroll_ > 0) {
    --frames_to_scroll_;
    const float margin = to.y - from.y;
    ImGui::ScrollToBringRectIntoView(window, ImRect(from.x, from.y - margin, to.x, to.y + margin));
  }
  ImRect seen(from, to);
  seen.ClipWith(window->ClipRect);
  from_ = seen.Min;
  to_ = seen.Max;
}

// A widget that is gone leaves the focus to the one before it, as a reset arrow does to its row.
void PanelFocus::look_for_lost_focus() {
  const auto first_row = std::ranges::find(stops_, Stop::row, &std::pair<ImGuiID, Stop>::second);
  if (focused_ == 0 && first_row != stops_.end()) {
    go_to(first_row->first);
  } else if (!stops_.empty()) {
    go_to(stops_[std::min(place_ > 0 ? place_ - 1 : 0, stops_.size() - 1)].first);
  }
}

void PanelFocus::end_frame(const Theme& theme) {
  is_last_ = false;
  if (!has_keys_) return;
  if (name_.empty()) return look_for_lost_focus();
  if (wish_.step != 0) {
    stops_before_ = stops_;
    move(wish_.step > 0 ? 1 : -1);
  }
  if (to_.x <= from_.x || to_.y <= from_.y) return;
  const float margin = theme.px(2);
  ImGui::GetForegroundDrawList()->AddRect({from_.x - margin, from_.y - margin}, {to_.x + margin, to_.y + margin},
                                          colour::focus, theme.px(5), ImDrawFlags_None, theme.px(2));
}

}  // namespace throng::app
