#pragma once

#include <memory>
#include <optional>

#include "app/settings/settings.h"
#include "app/show/show.h"
#include "app/window/frame_reporter.h"
#include "app/window/panel/overlay.h"

namespace throng::app {

/// The overlay in pictures without a window, or the legend and ids above heads alone. No mouse moves there.
class DrawnOverlay {
 public:
  explicit DrawnOverlay(const DemoOptions& options) : options_(options) {}

  /// Draws it over the show's picture, which shows the frame that was animated last. Errors: the figures of --ui=fixed
  /// cannot be read; the device failed.
  Status draw(Show& show);
  /// Writes where its widgets are, if that is asked for. Errors: the file cannot be written.
  Status write_map() const;

 private:
  Status begin(Show& show);
  Status report(Show& show);
  void build(Show& show);

  const DemoOptions& options_;
  Tuning tuning_;
  std::optional<FrameReporter> reporter_;  // from the first picture on
  std::unique_ptr<Overlay> overlay_;
};

}  // namespace throng::app
