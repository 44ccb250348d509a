#pragma once

#include <optional>

#include "app/report/frame_report.h"
#include "app/view/input.h"

namespace throng::app {

/// Tells a click at the crowd from a drag, and from what is meant for the overlay.
class CrowdClick {
 public:
  /// Once a frame. `pointer_free`: the overlay does not use it. Where the left button was pressed and, in this frame,
  /// let go again.
  std::optional<PicturePoint> update(const InputFrame& input, bool pointer_free);

 private:
  bool was_down_ = false;
  std::optional<PicturePoint> pressed_at_;  // at the crowd, and the pointer has stayed there
};

}  // namespace throng::app
