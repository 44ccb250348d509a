#pragma once

#include "app/demo/crowd_editor.h"
#include "app/demo/frame_reporter.h"
#include "app/demo/unkept_values.h"
#include "app/demo/window_camera.h"
#include "app/demo/window_input.h"
#include "app/report/tuning_sweep.h"
#include "app/settings/settings.h"
#include "app/show/show.h"

namespace throng::app {

/// All that the parts of a window's loop share.
struct WindowSession {
  WindowSession(Show& show_in_window, const DemoOptions& given)
      : show(show_in_window),
        options(given),
        unkept(show.stage().tuning()),
        input(show.painter().context().window()),
        camera(show),
        reporter(show),
        editor(show, reporter) {}

  Messages& messages() { return reporter.messages(); }

  Show& show;
  const DemoOptions& options;
  UnkeptValues unkept;
  WindowInput input;
  WindowCamera camera;
  FrameReporter reporter;
  CrowdEditor editor;  ///< it has the values that the person asks for
  TuningSweep sweep;
};

}  // namespace throng::app
