#pragma once

#include <string>

#include "app/overlay/overlay.h"

namespace throng::app {

/// An overlay with a person at it. The person acts by the names of the ui map, one frame at a time, without a window.
class OverlayDriver {
 public:
  /// The window in pixels. It is as tall as the longest tab, so that nothing that is clicked at is scrolled away.
  static constexpr int width = 1280, height = 1120;
  int shown_height = height;  ///< of the frames to come

  explicit OverlayDriver(const std::string& fonts = std::string(THRONG_SOURCE_DIR) + "/assets/fonts");

  /// Lets frames pass, by default enough to see every event. Returns the commands of all of them added up.
  OverlayCommands frames(int count = 6);

  OverlayCommands click(const std::string& widget);
  void double_click(const std::string& widget);
  /// Presses in the middle and lets go at a share of the width, 0 to 1.
  void drag(const std::string& widget, float share);
  /// Presses in the middle of one and lets go in the middle of another.
  OverlayCommands drag_to(const std::string& widget, const std::string& other);
  OverlayCommands press(Key key);
  void hold(Key key);
  void let_go(Key key);
  void type(const std::string& text);
  void point_at(float x, float y);
  /// Points at a share of the width of a widget.
  void point_at(const std::string& widget, float share);
  /// Presses or lets go of the left button.
  void button(bool down);

  [[nodiscard]] bool sees(const std::string& widget) const { return overlay.ui_map().find(widget) != nullptr; }

  Overlay overlay;
  FrameReport report;
  Tuning tuning;
  std::string clipboard;
  InputQueue input;
};

/// Returns a report that has everything that the overlay can show.
FrameReport full_report();

}  // namespace throng::app
