#pragma once

#include <string>

#include <gtest/gtest.h>

#include "app/window/panel/overlay.h"

namespace throng::app {

/// An overlay with a person at it. The person acts by the names of the ui map, one frame at a time, without a window.
class OverlayDriver {
 public:
  /// The window in pixels. It is as tall as the longest tab, so that nothing that is clicked at is scrolled away.
  static constexpr int width = 1280, height = 1500;
  int shown_height = height;  ///< of the frames to come

  explicit OverlayDriver(const std::string& fonts = std::string(THRONG_SOURCE_DIR) + "/assets/fonts");

  /// Lets frames pass, by default enough to see every event. Returns what the person asked for in all of them. Other
  /// values, clips and times of a recorded crowd are taken; everything else is only asked for.
  Requests frames(int count = 6);

  Requests click(const std::string& widget);
  void double_click(const std::string& widget);
  /// Presses in the middle and lets go at a share of the width, 0 to 1.
  void drag(const std::string& widget, float share);
  /// Presses in the middle of one and lets go in the middle of another.
  Requests drag_to(const std::string& widget, const std::string& other);
  Requests press(Key key);
  void hold(Key key);
  void let_go(Key key);
  void type(const std::string& text);
  void point_at(float x, float y);
  /// Points at a share of the width of a widget.
  void point_at(const std::string& widget, float share);
  /// Presses or lets go of the left button.
  void button(bool down);

  /// Returns the place of a widget; null where it is not seen.
  [[nodiscard]] const UiRectangle* find(const std::string& widget) const;
  /// Returns why a row has no effect; null where it has one, or is not there.
  [[nodiscard]] const std::string* why_idle(const std::string& row) const;
  [[nodiscard]] bool sees(const std::string& widget) const { return find(widget) != nullptr; }

  Overlay overlay;
  FrameReport report;
  Tuning tuning;
  std::string clipboard;
  InputQueue input;
};

/// Returns whether a request of that kind is in a list.
template <typename Asked>
bool asks(const Requests& requests) {
  return last_of<Asked>(requests) != nullptr;
}

/// Returns the last request of that kind in a list, in which one must be.
template <typename Asked>
Asked asked(const Requests& requests) {
  const Asked* const last = last_of<Asked>(requests);
  EXPECT_NE(last, nullptr) << "it is not asked for";
  return last == nullptr ? Asked{} : *last;
}

/// Returns a report that has everything that the overlay can show.
FrameReport full_report();

}  // namespace throng::app
