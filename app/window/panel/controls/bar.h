#pragma once

#include <string>

#include "app/window/panel/controls/widgets.h"

namespace throng::app {

/// The controls of a bar at the foot of the crowd, taken from the left and the right end of a line. The room in the
/// middle is for a track or for words.
class BarControls {
 public:
  static constexpr float height = 24, gap = 6, button = 32;

  BarControls(Widgets& widgets, const Area& place) : widgets_(widgets), place_(place) {}

  /// Shows a control at the left or the right end of the room left. Returns whether it was clicked.
  bool left(const std::string& name, float width) { return show(name, take(width, true)); }
  bool right(const std::string& name, float width) { return show(name, take(width, false)); }
  /// Returns the place of the last control.
  [[nodiscard]] const Area& last() const { return last_; }
  [[nodiscard]] const Area& rest() const { return place_; }
  [[nodiscard]] bool has_room_for(float width) const { return place_.width() > widgets_.theme().px(width); }

  /// These draw into the last control: its ground, its words, what a player has on its buttons.
  void fill(bool chosen) const;
  void write(const std::string& words, bool chosen) const;
  void draw_pause() const;
  /// Draws a triangle that points to the right, or to the left where `way` is -1; with a bar before its tip where it
  /// steps.
  void draw_arrow(float way, bool steps) const;

 private:
  Area take(float plain_width, bool from_left);
  bool show(const std::string& name, const Area& place);
  [[nodiscard]] ImVec2 middle() const { return {(last_.from.x + last_.to.x) / 2, (last_.from.y + last_.to.y) / 2}; }

  Widgets& widgets_;
  Area place_, last_;
};

/// Returns "0.25x".
std::string times_words(float times);

}  // namespace throng::app
