#pragma once

#include <filesystem>
#include <string>

#include <glm/vec2.hpp>

#include "app/settings/settings.h"
#include "app/show/report/tuning_sweep.h"
#include "app/window/crowd_editor.h"
#include "app/window/frame_rate_keeper.h"
#include "app/window/frame_reporter.h"
#include "app/window/loading.h"
#include "app/window/unsaved_work.h"
#include "app/window/window_camera.h"
#include "app/window/window_input.h"

namespace throng::app {

class Show;

/// All that the parts of a window's loop share.
struct WindowSession {
  WindowSession(Show& show_in_window, const DemoOptions& given);

  Messages& messages() { return reporter.messages(); }

  /// Returns the values that the panel shows: the values that a person asks for, at the cost that holds the frame rate.
  Tuning shown_values() const { return rate.kept(editor.tuning()); }
  /// Returns the scale of the panel: that of the display, unless the command line asks for another.
  float panel_scale() const;
  /// Returns the values that a person asks for at the quality of a headless run, for a picture or a video as a file.
  Tuning best_values() const;
  /// Gives the show the values of the next frame: those of the exact crowd while a person holds its key, of the next
  /// stop of a sweep, or as the panel shows them.
  void show_wanted_values(bool exact_crowd);
  /// Leaves quality, sizes and recent files of the window to the next one, where a person changed them in this one.
  void keep_settings(glm::ivec2 window_size, int panel_width) const;
  /// Returns the work of the person that a crowd file holds.
  CrowdWork crowd_work() const;
  /// Names a file that was opened or saved among the recent ones.
  void note_recent(const std::filesystem::path& file);
  /// Adds the cost of the frame that was animated last to the sweep that runs, and reports the sweep.
  void measure_for_sweep();

  Show& show;
  const DemoOptions& options;
  UnsavedWork unsaved;
  WindowInput input;
  WindowCamera camera;
  FrameReporter reporter;
  CrowdEditor editor;  ///< it has the values that the person asks for
  Loading loading;
  FrameRateKeeper rate;
  TuningSweep sweep;
  const std::string first_quality;  ///< that the window started with
  int first_panel_width = 0;        ///< likewise, in pixels of a plain screen; 0: as usual
};

}  // namespace throng::app
