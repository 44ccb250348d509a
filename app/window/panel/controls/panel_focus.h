#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>

#include "app/show/camera/input.h"
#include "app/window/panel/controls/theme.h"

namespace throng::app {

/// The keyboard in the panel: the widget that has it, and what keys ask of that widget. In each frame every widget that
/// can be clicked or typed into adds itself as a stop; keys go from stop to stop in that order. While the keyboard is
/// not in the panel, nothing is added.
///
///   if (focus.has_keys()) focus.add(ImGui::GetID("Step"), "Step", from, to, PanelFocus::Stop::plain);
///   if (focus.take_activation()) ...
class PanelFocus {
 public:
  enum class Stop : std::uint8_t { plain, row };
  /// Says which parts have the keys before the panel.
  struct Before {
    bool typing = false;  ///< a text field
    bool list = false;    ///< an open list
    bool search = false;  ///< a search, which Esc empties first
  };

  [[nodiscard]] bool has_keys() const { return has_keys_; }
  void give_back() { has_keys_ = false; }
  /// Takes the keyboard to the first row that is shown below; it stays there.
  void go_to_first_row();
  /// The next row that is added gets the focus, if the keyboard is in the panel.
  void go_to_next_row() { wants_next_row_ = has_keys_; }
  void go_to(ImGuiID stop);

  /// Begins a frame: F6 and Esc take the keyboard or give it back. Removes the keys that belong to the panel from the
  /// input.
  void begin_frame(InputFrame& input, const Before& before);
  /// Ends it: marks the widget that has the focus, over all that was drawn.
  void end_frame(const Theme& theme);

  /// Adds a widget; its wishes can be taken until the next one is added. A disabled widget can have the focus, so that
  /// its reason can be read, but gets no wish.
  void add(ImGuiID id, const std::string& name, ImVec2 from, ImVec2 to, Stop kind);
  /// Returns whether the widget that was added last has the focus.
  [[nodiscard]] bool is_at_last_added() const { return is_last_; }
  bool take_activation() { return take_wish(wish_.activate); }
  bool take_reset() { return take_wish(wish_.reset); }
  /// Returns steps to the right; steps to the left are negative. These keys leave a widget that takes no step.
  int take_step() { return take_wish(wish_.step); }

  /// Returns the name of the widget that has the focus; empty: none.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Returns whether the focus has been where it is long enough to explain the widget.
  [[nodiscard]] bool rests() const;
  /// Returns whether a key that steps through a value is held.
  [[nodiscard]] bool is_stepping() const { return is_stepping_; }

 private:
  struct Wish {
    bool activate = false, reset = false;
    int step = 0;
  };
  struct WaitingKey {
    Key key;
    bool shift;
  };

  template <class Value>
  Value take_wish(Value& wish) {
    return is_last_ && takes_keys_ ? std::exchange(wish, Value{}) : Value{};
  }
  void take_or_give_back(InputFrame& input, const Before& before);
  void take_pressed(InputFrame& input);
  void use_waiting_keys();
  bool use(const WaitingKey& waiting);
  void move(int stops);
  void look_for_lost_focus();

  bool has_keys_ = false, is_stepping_ = false;
  bool is_last_ = false, takes_keys_ = false;  // of the widget that was added last
  bool wants_next_row_ = false;
  ImGuiID focused_ = 0;  // 0: the first row gets it
  std::size_t place_ = 0;
  std::string name_;
  Wish wish_;
  std::deque<WaitingKey> waiting_;  // keys after a key that a widget still has to see
  std::vector<std::pair<ImGuiID, Stop>> stops_, stops_before_;
  ImVec2 from_, to_;  // of the widget that has the focus, as far as it is seen
  int frames_to_scroll_ = 0;
  double moved_at_ = 0;
};

}  // namespace throng::app
