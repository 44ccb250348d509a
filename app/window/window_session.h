#pragma once

#include "app/settings/settings.h"
#include "app/show/report/tuning_sweep.h"
#include "app/window/crowd_editor.h"
#include "app/window/frame_reporter.h"
#include "app/window/unsaved_values.h"
#include "app/window/window_camera.h"
#include "app/window/window_input.h"

namespace throng::app {

class Show;

/// All that the parts of a window's loop share.
struct WindowSession {
  WindowSession(Show& show_in_window, const DemoOptions& given);

  Messages& messages() { return reporter.messages(); }

  /// Gives the show the values of the next frame: those of the exact crowd while a person holds its key, of the next
  /// stop of a sweep, or as asked for.
  void show_wanted_values(bool exact_crowd);
  /// Adds the cost of the frame that was animated last to the sweep that runs, and reports the sweep.
  void measure_for_sweep();

  Show& show;
  const DemoOptions& options;
  UnsavedValues unsaved;
  WindowInput input;
  WindowCamera camera;
  FrameReporter reporter;
  CrowdEditor editor;  ///< it has the values that the person asks for
  TuningSweep sweep;
};

}  // namespace throng::app
