#pragma once

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
        tuning(show.stage().tuning()),
        accepted(tuning),
        unkept(tuning),
        input(show.painter().context().window()),
        camera(show),
        reporter(show) {}

  Messages& messages() { return reporter.messages(); }

  Show& show;
  const DemoOptions& options;
  Tuning tuning;    ///< the values that the person asks for
  Tuning accepted;  ///< the last of them that could be
  UnkeptValues unkept;
  WindowInput input;
  WindowCamera camera;
  FrameReporter reporter;
  TuningSweep sweep;
};

}  // namespace throng::app
