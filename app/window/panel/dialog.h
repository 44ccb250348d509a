#pragma once

#include <string>

#include "app/window/panel/controls/widgets.h"

namespace throng::app {

/// A card in the middle of the window that has pointer and keyboard until it is answered. What lies below is seen, and
/// takes no click.
///
///   const Dialog dialog(widgets, "Open a file", {560, 420});
class Dialog {
 public:
  /// `size` is in pixels of a plain screen; a smaller window gets a smaller card.
  Dialog(Widgets& widgets, const char* title, ImVec2 size);
  ~Dialog();
  Dialog(const Dialog&) = delete;
  Dialog& operator=(const Dialog&) = delete;

  /// Returns the place below the title, without the margin.
  [[nodiscard]] Area content() const { return content_; }
  /// Returns the place of the last line, at the foot of the content.
  [[nodiscard]] Area foot() const;

 private:
  const Theme& theme_;
  Area content_;
};

}  // namespace throng::app
